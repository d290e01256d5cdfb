#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::actuator {

/// Angle of every joint for which heat paths are taken, rad: 30 degrees, where the prototype works at its continuous
/// current (57 degrees over two joints at 1.05 A). One angle for all designs, so that heat does not depend on dynamics.
/// An open face passes less heat to its neighbour, a closed one more. At 0, 30 and 60 degrees the continuous current of
/// the prototype's coils is 1.167, 1.100 and 1.093 A, which hardly depends on the angle; that of its magnet is 0.89,
/// 1.44 and 1.60 A, because the magnet has no other source of heat than its neighbours: a finger that is held closed (a
/// blocked grasp) heats its magnets to their limit at 38 % less current than at this angle.
inline constexpr double thermal_joint_angle = 30.0 * 3.14159265358979323846 / 180.0;

/// Thermal chain of an assembled design: a node per component, base to tip.
/// `joint_angle` of every joint in rad, >= 0.
[[nodiscard]] thermal::Network heat_network(const Design& design, const Assembly& assembly,
                                            double joint_angle = thermal_joint_angle);

/// The same with each joint at its own angle, rad, base to tip: those of the case at hand (a finger that moves freely,
/// a finger that grips). Where a joint is pressed closed, its angle below 0 counts as 0. Throws std::invalid_argument
/// unless there is a finite angle for each joint.
[[nodiscard]] thermal::Network heat_network(const Design& design, const Assembly& assembly,
                                            const mechanics::JointVector& joint_angles);

}  // namespace coilwright::actuator
