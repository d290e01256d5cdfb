#pragma once

namespace coilwright::actuator {

/// How an actuator is driven and used. It stands beside a design, not in it, and travels with it in files.
struct OperatingPoint {
  double current{};   ///< in every coil while on, A; finite
  double duty = 1.0;  ///< fraction of the time that it is on, 0 to 1, for heat only; periods short beside thermal ones
};

}  // namespace coilwright::actuator
