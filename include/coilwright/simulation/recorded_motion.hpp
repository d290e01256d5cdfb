#pragma once

#include <vector>

#include "coilwright/simulation/transient.hpp"

namespace coilwright::simulation {

/// A motion as a record has it: the true joint angles, and the bending angle as the camera shows it.
struct RecordedMotion {
  std::vector<State> states{};           ///< one a sample of the input
  std::vector<double> bending_angles{};  ///< rad, with the sensor's offset, scale and delay if the model has them
};

/// The motion of `model` from `start` under `input`, recorded at its samples. Throws as simulate().
[[nodiscard]] RecordedMotion record_motion(const actuator::Model& model, const ModelInput& input, const State& start,
                                           const Accuracy& accuracy = {});

}  // namespace coilwright::simulation
