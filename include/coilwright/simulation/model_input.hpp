#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/commanded_input.hpp"

namespace coilwright::simulation {

/// What drives a model over time: one row a sample, held until the next (zero order) unless `straight` says otherwise.
struct ModelInput {
  std::vector<double> times{};                          ///< s, strictly increasing, at least one
  std::vector<actuator::CoilCurrents> currents{};       ///< A, a row a time
  std::vector<mechanics::JointVector> joint_torques{};  ///< N m, a row a time; empty: none

  /// A row a time: whether the input goes straight from this row to the next one instead of being held. Empty: nowhere;
  /// the last row has no next.
  std::vector<char> straight{};

  /// A row a time: whether the input passes this row without a corner, so that no integration needs to stop there. From
  /// a row that has none of it to the next such one the input is the smooth curve through both and all rows between
  /// them (algebra::SmoothCurve). Empty: nowhere. Only rows to and from which it goes straight may be passed so.
  std::vector<char> passed{};

  /// Whether it goes straight from row `row`.
  [[nodiscard]] bool goes_straight(std::size_t row) const {
    return row + 1 < times.size() && !straight.empty() && straight[row] != 0;
  }

  /// Whether it passes row `row` without a corner.
  [[nodiscard]] bool passes(std::size_t row) const { return !passed.empty() && passed[row] != 0; }

  /// Throws std::invalid_argument naming the sample and the rule when times do not increase, or when a row does not
  /// have one value per coil (joint) of `model`.
  void require_fits(const actuator::Model& model) const;

  /// The samples from `first` to one before `last`.
  [[nodiscard]] ModelInput part(std::size_t first, std::size_t last) const;
};

/// Throws std::invalid_argument with the rule where `model` cannot be driven so: no coils, a row without one value a
/// coil (joint), or a voltage across coils whose resistance is not known. Looks at the width of the first row alone.
void require_can_drive(const actuator::Model& model, const CommandedInput& command);

/// The currents and torques by which `command` drives `model`. Simulations, replays of measured runs and synthetic data
/// all use this function. Throws as require_can_drive() does.
[[nodiscard]] ModelInput model_input(const actuator::Model& model, const CommandedInput& command);

/// A step and a sine (see StepInput, SineInput) as `model` takes them.
[[nodiscard]] ModelInput step_input(const actuator::Model& model, const StepInput& step);
[[nodiscard]] ModelInput sine_input(const actuator::Model& model, const SineInput& sine);

}  // namespace coilwright::simulation
