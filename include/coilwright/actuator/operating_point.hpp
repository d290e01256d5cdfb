#pragma once

#include <optional>

namespace coilwright::actuator {

/// Where a finger presses on what it holds: a vertical wall without friction in front of it.
struct GraspPoint {
  /// Bending angle, each joint with the same share of it, at which the free finger would just touch the wall, rad; >=
  /// 0. It says how far the wall is from the straight finger: 0 is a wall that the straight finger touches.
  double opening = 0.0;
  std::optional<double> height{};  ///< of the contact along the last segment, from its joint, m; nothing: its tip
};

/// How an actuator is driven and used. It stands beside a design, not in it, and travels with it in files.
struct OperatingPoint {
  double current{};    ///< in every coil while on, A; finite
  double duty = 1.0;   ///< fraction of the time that it is on, 0 to 1, for heat only; periods short beside thermal ones
  GraspPoint grasp{};  ///< where grasp forces are taken
};

}  // namespace coilwright::actuator
