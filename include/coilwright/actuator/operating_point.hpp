#pragma once

#include <optional>

namespace coilwright::actuator {

/// The point at which a finger presses on a vertical wall without friction.
struct GraspPoint {
  /// Bending angle at which the free finger would just touch the wall, rad, >= 0; each joint has the same share of it.
  /// At 0 the straight finger touches the wall.
  double opening = 0.0;
  std::optional<double> height{};  ///< of the contact along the last segment, from its joint, m; absent: its tip
};

/// Connection of the coils to one supply; each carries the operating point's current.
enum class Wiring {
  parallel,  ///< each coil across the supply, as the source paper's prototype at 4.2 V; currents add up
  series     ///< one after the other: voltages add up
};

/// The battery or power supply that drives all coils of an actuator.
struct Supply {
  Wiring wiring = Wiring::parallel;
  double resistance{};  ///< inside the battery or supply, with its leads, ohm; finite, >= 0
  /// Open-circuit voltage, V; finite, > 0. A current that needs more voltage at the temperature of its coils cannot be
  /// driven: see simulation::part_limits().
  std::optional<double> voltage{};
};

/// The poses in which an operating point is held, for heat.
enum class HeldCases { both, free, gripping };

/// The drive and the use of an actuator. It is not part of a design, and travels with it in files.
struct OperatingPoint {
  double current{};    ///< in every coil while on, A; finite
  double duty = 1.0;   ///< fraction of the time that it is on, 0 to 1, for heat only; periods short beside thermal ones
  GraspPoint grasp{};  ///< point at which grasp forces are taken
  std::optional<double> period{};     ///< of the duty cycle, s; finite, > 0; tells the ripple of temperature alone
  HeldCases cases = HeldCases::both;  ///< pose whose heat counts if one figure represents the operating point
  Supply supply{};
};

}  // namespace coilwright::actuator
