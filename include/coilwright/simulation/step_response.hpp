#pragma once

#include <optional>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// Figures of the bending angle (sum of the joint angles) in one step from rest.
struct StepResponse {
  mechanics::JointVector steady_angles;   ///< the stable equilibrium in which this motion ends, rad
  double peak_speed{};                    ///< largest |d(bending angle)/dt|, rad/s
  double peak_speed_time{};               ///< s
  double peak_angle{};                    ///< largest bending angle on the way, rad, signed
  double peak_joint_angle{};              ///< largest magnitude of any joint's angle on the way, rad
  double overshoot{};                     ///< beyond the steady angle, over the change from rest; >= 0
  std::optional<double> rise_time{};      ///< from 10 to 90 % of the change, s; absent for a change below 1e-6 rad
  std::optional<double> settling_time{};  ///< last time outside 2 % of the change about the end, s; else absent
};

/// Limits up to which a step is followed.
struct StepLimits {
  double longest = 60.0;  ///< s; a motion that has not decayed by then has no result
  /// Error of one integration step, relative to angle, rate and change. At 1e-5 the peak speed is good to 1e-5 and the
  /// settling time to 1e-4 (docs/theory/simulation.md).
  double relative_accuracy = 1e-5;
};

/// Simulates a step from the pose `rest` (rad, at zero speed) to constant `currents` (A) at time 0 until the motion
/// cannot leave the 2 % band: until its energy about the equilibrium is below that of four fifths of the band. Absent
/// if it does not decay in time or in 200,000 steps, or leaves the model.
[[nodiscard]] std::optional<StepResponse> step_response(const actuator::Model& model,
                                                        const actuator::CoilCurrents& currents,
                                                        const mechanics::JointVector& rest,
                                                        const StepLimits& limits = {});

}  // namespace coilwright::simulation
