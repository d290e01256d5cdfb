#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/commanded_input.hpp"

namespace coilwright::simulation {

/// The drive of a model over time: one row for each sample, held until the next (zero order) unless `straight` says
/// otherwise.
struct ModelInput {
  std::vector<double> times{};                          ///< s, strictly increasing, at least one
  std::vector<actuator::CoilCurrents> currents{};       ///< A, a row a time
  std::vector<mechanics::JointVector> joint_torques{};  ///< N m, a row a time; empty: none

  /// For each row whether the input goes straight from it to the next one instead of being held. Empty: nowhere. The
  /// last row has no next.
  std::vector<char> straight{};

  /// For each row whether the input passes it without a corner, so that no integration needs to stop there. Between two
  /// rows that are not passed the input is the smooth curve through both and all rows between them
  /// (algebra::SmoothCurve). Empty: nowhere. Only rows to and from which the input goes straight may be passed.
  std::vector<char> passed{};

  /// Whether the input goes straight from row `row`.
  [[nodiscard]] bool goes_straight(std::size_t row) const {
    return row + 1 < times.size() && !straight.empty() && straight[row] != 0;
  }

  /// Whether the input passes row `row` without a corner.
  [[nodiscard]] bool passes(std::size_t row) const { return !passed.empty() && passed[row] != 0; }

  /// Throws std::invalid_argument naming the sample and the rule if times do not increase, or if a row does not have
  /// one value per coil (joint) of `model`.
  void require_fits(const actuator::Model& model) const;

  /// The samples from `first` to one before `last`.
  [[nodiscard]] ModelInput part(std::size_t first, std::size_t last) const;
};

/// Throws std::invalid_argument with the rule if `model` cannot be driven by `command`: no coils, a row without one
/// value per coil (joint), or a voltage across coils whose resistance is not known. Only the width of the first row is
/// checked.
void require_can_drive(const actuator::Model& model, const CommandedInput& command);

/// The currents and torques by which `command` drives `model`. Simulations, replays of measured runs and synthetic data
/// all use this function. Throws as require_can_drive() does.
[[nodiscard]] ModelInput model_input(const actuator::Model& model, const CommandedInput& command);

/// A step or a sine (see StepInput, SineInput) as input of `model`.
[[nodiscard]] ModelInput step_input(const actuator::Model& model, const StepInput& step);
[[nodiscard]] ModelInput sine_input(const actuator::Model& model, const SineInput& sine);

}  // namespace coilwright::simulation
