#pragma once

#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/systems/rig/per_fidelity.hpp"

namespace coilwright::systems::rig {

/// The paper's bench of Fig. 17: one joint's rigid counterpart, a coil and a magnet hinged without silicone, held at an
/// angle by a force gauge.
struct TorqueBench {
  double axis_offset{};             ///< hinge to coil axis on the bench (h), m; finite, beyond the parts' radius
  double gauge_distance = 30e-3;    ///< gauge's line of force to the hinge, m; finite, > 0
  double current = 1.4;             ///< A; finite, not 0
  std::vector<double> angles = {};  ///< of the joint, rad; 0 to 120 degrees, at least one
};

/// The paper's settings for a design: a hinge 2 mm further out than the design's own, and 0 to 82.5 degrees in steps of
/// 7.5. Precondition: construction_faults(design) is empty.
[[nodiscard]] TorqueBench paper_torque_bench(const actuator::Design& design);

/// One reading of the bench, without weight: the bench lies flat, or its gauge is balanced at each angle.
struct TorqueReading {
  double torque{};       ///< about the hinge, N m, positive where it opens the joint
  double gauge_force{};  ///< force that holds it, N
};

/// The readings of the bench at one angle.
struct TorqueBenchPoint {
  double angle{};  ///< rad
  PerFidelity<TorqueReading> reading{};

  /// Relative error of the approximation: torque by the line of centres over the exact one, minus one.
  [[nodiscard]] double error_of_line_of_centres() const {
    return reading.line_of_centres.torque / reading.exact.torque - 1.0;
  }
};

/// The joint on the bench as a design of its own: the first coil and magnet that are neighbours, hinged at
/// `axis_offset`, m, with those effects of drive and magnetics that it can have. Its torque is the bench's reading; its
/// stiffness and masses are meaningless.
[[nodiscard]] actuator::Design rigid_counterpart(const actuator::Design& design, double axis_offset);

/// Readings at the bench's angles, in their order. Throws std::invalid_argument naming field, rule and value, or with
/// the rule of construction that the counterpart breaks.
[[nodiscard]] std::vector<TorqueBenchPoint> readings(const actuator::Design& design, const TorqueBench& bench);

/// Mean magnitude of the difference between the two fidelities' torques, N m. Precondition: there is a point.
[[nodiscard]] double mean_difference(const std::vector<TorqueBenchPoint>& points);

}  // namespace coilwright::systems::rig
