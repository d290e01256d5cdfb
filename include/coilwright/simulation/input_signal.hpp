#pragma once

#include <vector>

#include "coilwright/actuator/model.hpp"

namespace coilwright::simulation {

/// What drives the finger over time: one row a sample, held until the next (zero order).
struct InputSignal {
  std::vector<double> times;                            ///< s, strictly increasing, at least one
  std::vector<actuator::CoilCurrents> currents;         ///< A, a row a time
  std::vector<mechanics::JointVector> joint_torques{};  ///< N m, a row a time; empty: none

  /// Throws std::invalid_argument naming the sample and the rule when times do not increase, or when a row does not
  /// have one value per coil (joint) of `model`.
  void check(const actuator::Model& model) const;
};

/// `current` in every coil from time 0, sampled at `interval` for `duration`. All in SI, > 0.
struct StepInput {
  double current{};   ///< A
  double duration{};  ///< s
  double interval{};  ///< s
};
[[nodiscard]] InputSignal step_input(const actuator::Model& model, const StepInput& step);

/// offset + amplitude sin(2 pi f t) in every coil, held between samples: (23) of the paper at 0.7 A and 0.7 A.
struct SineInput {
  double amplitude{};  ///< A
  double offset{};     ///< A
  double frequency{};  ///< Hz
  double duration{};   ///< s
  double interval{};   ///< s
};
[[nodiscard]] InputSignal sine_input(const actuator::Model& model, const SineInput& sine);

}  // namespace coilwright::simulation
