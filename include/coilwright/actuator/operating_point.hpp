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

/// How the coils hang on one supply; each carries the operating point's current.
enum class Wiring {
  parallel,  ///< each coil across the supply, as the source paper's prototype at 4.2 V; currents add up
  series     ///< one after the other: voltages add up
};

/// What drives all coils of an actuator: a battery or a power supply.
struct Supply {
  Wiring wiring = Wiring::parallel;
  double resistance{};  ///< inside the battery or supply, with its leads, ohm; finite, >= 0
  /// Of the open circuit, V; finite, > 0. What needs more at the temperature of its coils cannot be driven: see
  /// simulation::part_limits().
  std::optional<double> voltage{};
};

/// In which poses an operating point is held, for heat.
enum class HeldCases { both, free, gripping };

/// How an actuator is driven and used. It stands beside a design, not in it, and travels with it in files.
struct OperatingPoint {
  double current{};    ///< in every coil while on, A; finite
  double duty = 1.0;   ///< fraction of the time that it is on, 0 to 1, for heat only; periods short beside thermal ones
  GraspPoint grasp{};  ///< where grasp forces are taken
  std::optional<double> period{};     ///< of the duty cycle, s; finite, > 0; tells the ripple of temperature alone
  HeldCases cases = HeldCases::both;  ///< whose heat counts where one figure stands for the operating point
  Supply supply{};
};

}  // namespace coilwright::actuator
