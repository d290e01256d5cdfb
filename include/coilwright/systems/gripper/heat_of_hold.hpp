#pragma once

#include <optional>

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/systems/gripper/grasp.hpp"

namespace coilwright::systems::gripper {

/// The heat of one finger, the left, bent as in this grasp against a wall; absent if it has no performance there.
/// `finger` is the design of the gripper; current and duty of the point count.
[[nodiscard]] std::optional<simulation::Heat> heat_of_hold(const actuator::Design& finger, const Gripper& gripper,
                                                           const Grasp& grasp, const actuator::OperatingPoint& point);

}  // namespace coilwright::systems::gripper
