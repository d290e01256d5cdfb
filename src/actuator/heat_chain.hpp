#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/thermal/chain.hpp"

namespace coilwright::actuator {

/// Geometry and materials of the heat paths of an assembled design at `joint_angles` (rad, base to tip; below 0:
/// closed).
[[nodiscard]] thermal::HeatChain heat_chain(const Design& design, const Assembly& assembly,
                                            const mechanics::JointVector& joint_angles);

/// Every joint of an assembled design at the same angle, rad.
[[nodiscard]] mechanics::JointVector joints_at(const Assembly& assembly, double joint_angle);

}  // namespace coilwright::actuator
