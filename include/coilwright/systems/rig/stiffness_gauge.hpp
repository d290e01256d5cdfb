#pragma once

#include <optional>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/systems/rig/per_fidelity.hpp"

namespace coilwright::systems::rig {

/// The paper's force gauge of Figs 10b and 11: without current it presses square on the last segment and holds one
/// joint open, all others straight.
struct StiffnessGauge {
  std::vector<double> angles = {};  ///< of the joint, rad; above 0 to 120 degrees, at least one
  std::optional<int> joint{};       ///< from 0 at the base; absent: the last, as the paper has it
  std::optional<double> height{};  ///< of the gauge along the last segment, from its joint, m; > 0, not beyond the tip;
                                   ///< absent: its tip
};

/// The paper's settings: 15 to 90 degrees in steps of 15.
[[nodiscard]] StiffnessGauge paper_stiffness_gauge();

/// One reading of the gauge.
struct StiffnessReading {
  double force{};      ///< of the gauge, N, positive where it pushes towards opening
  double stiffness{};  ///< equivalent coefficient: force times arm over angle, N m/rad
};

/// The reading of the gauge at one angle. Without current the fidelities differ only in the forces between magnets of
/// the actuator.
struct StiffnessPoint {
  double angle{};                           ///< rad
  PerFidelity<StiffnessReading> level{};    ///< the plane of bending level: no weight in the reading
  PerFidelity<StiffnessReading> hanging{};  ///< under the design's gravity and tilt
  double hinge_torque{};                    ///< torque that the hinge alone needs, N m
  double first_hinge_torque{};              ///< hinge torque of the first joint at this angle, N m
};

/// All readings of one gauge.
struct StiffnessReadings {
  int joint{};   ///< from 0
  double arm{};  ///< joint to the line of the gauge's force, m
  std::vector<StiffnessPoint> points{};
};

/// Readings at the gauge's angles, in their order. Throws std::invalid_argument naming field, rule and value.
/// Precondition: construction_faults(design) is empty.
[[nodiscard]] StiffnessReadings readings(const actuator::Design& design, const StiffnessGauge& gauge);

/// Mean and standard deviation (over n) of equivalent coefficients.
struct StiffnessSpread {
  double mean{};       ///< N m/rad
  double deviation{};  ///< N m/rad
};
/// The spread over the points in the level or in the hanging posture.
[[nodiscard]] StiffnessSpread spread(const StiffnessReadings& readings,
                                     PerFidelity<StiffnessReading> StiffnessPoint::*posture,
                                     magnetics::Fidelity fidelity);

}  // namespace coilwright::systems::rig
