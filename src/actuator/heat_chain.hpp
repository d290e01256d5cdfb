#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/thermal/chain.hpp"

namespace coilwright::actuator {

/// Geometry and materials of the heat paths of an assembled design, every joint at `joint_angle` (rad).
[[nodiscard]] thermal::HeatChain heat_chain(const Design& design, const Assembly& assembly, double joint_angle);

}  // namespace coilwright::actuator
