#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::actuator {

/// Angle of every joint for which heat paths are taken, rad: 30 degrees, where the prototype works at its continuous
/// current (57 degrees over two joints at 1.05 A). One angle for all designs, so that heat does not depend on dynamics;
/// an open face passes less heat to its neighbour, a closed one more: from 0 to 60 degrees the prototype's continuous
/// current moves by the amount that docs/validation.md prints.
inline constexpr double thermal_joint_angle = 30.0 * 3.14159265358979323846 / 180.0;

/// Thermal chain of an assembled design: a node per component, base to tip.
/// `joint_angle` of every joint in rad, >= 0.
[[nodiscard]] thermal::Network heat_network(const Design& design, const Assembly& assembly,
                                            double joint_angle = thermal_joint_angle);

}  // namespace coilwright::actuator
