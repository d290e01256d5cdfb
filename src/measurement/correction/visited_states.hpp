#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/actuator/model/torque_correction.hpp"
#include "coilwright/simulation/state.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::correction {

/// What a joint did at one sample: its angle, rad, its rate, rad/s, and the current of its coil, A.
struct JointSample {
  std::array<double, 3> values{};  ///< by actuator::CorrectionVariable
  [[nodiscard]] double of(actuator::CorrectionVariable variable) const {
    return values[static_cast<std::size_t>(variable)];
  }
};

/// What all joints did in all motions, and the farthest poses.
struct VisitedStates {
  std::vector<JointSample> samples{};  ///< of each joint at each sample, thinned evenly where there are too many
  /// For each motion the state and the coil currents where its bending angle was largest and smallest.
  struct Extreme {
    simulation::State state;
    actuator::CoilCurrents currents;
  };
  std::vector<Extreme> extremes{};
};

/// The motions of the fit runs as `fitted` simulates them. Runs that cannot be simulated are left out.
[[nodiscard]] VisitedStates visited_states(std::span<const replay::PreparedRun> runs,
                                           const identification::FittedHypothesis& fitted);

}  // namespace coilwright::measurement::correction
