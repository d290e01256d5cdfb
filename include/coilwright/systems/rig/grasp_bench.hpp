#pragma once

#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/systems/rig/per_fidelity.hpp"

namespace coilwright::systems::rig {

/// The paper's bench of Fig. 9b: the finger hangs with its tip against a force sensor on a wall, under a current in
/// every coil.
struct GraspBench {
  std::vector<double> currents = {0.0, 0.35, 0.7, 1.05, 1.4};  ///< A; finite, at least one
  actuator::GraspPoint grasp{};                                ///< place of the wall, and of the contact on the finger
};

/// The reading of the sensor at one current, by both fidelities.
struct GraspBenchPoint {
  double current{};               ///< A
  PerFidelity<double> force{};    ///< on the wall, N, >= 0; the sensor does not hold the finger back
  PerFidelity<double> bending{};  ///< of the pressing finger, rad
};

/// Readings at the bench's currents, in their order. Throws std::invalid_argument naming field, rule and value,
/// std::runtime_error naming the current if the finger comes to rest nowhere on the wall. Precondition:
/// construction_faults(design) is empty.
[[nodiscard]] std::vector<GraspBenchPoint> readings(const actuator::Design& design, const GraspBench& bench);

}  // namespace coilwright::systems::rig
