#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// The motion over time that a FreeMotion summarises.
struct StepMotion {
  std::vector<double> times{};  ///< s, from 0, even
  std::vector<State> states{};  ///< one a time; of the joints
};

/// The free finger of an evaluated design in a step from rest to its operating point's current at time 0, with magnets
/// at the temperatures of the hold: the step whose peaks and times are in Performance::free, sampled at `samples` (2 or
/// more) even times over `duration` (s, > 0). Absent if Performance::free has no motion. Throws std::invalid_argument
/// for another duration or number of samples, std::runtime_error as simulate() does.
[[nodiscard]] std::optional<StepMotion> step_motion(const EvaluatedDesign& evaluated, double duration,
                                                    std::size_t samples);

/// Index of the sample in which the bending angle is farthest from its first value. The motion must not be empty.
[[nodiscard]] std::size_t peak_of(const StepMotion& motion);

}  // namespace coilwright::simulation
