#include "coilwright/systems/gripper/heat_of_hold.hpp"

#include <algorithm>
#include <variant>

namespace coilwright::systems::gripper {

std::optional<simulation::Heat> heat_of_hold(const actuator::Design& finger, const Gripper& gripper, const Grasp& grasp,
                                             const actuator::OperatingPoint& point) {
  actuator::OperatingPoint held = point;
  held.grasp = {.opening = std::max(0.0, grasp.left.sum())};
  const auto performance = simulation::performance_of(finger, gripper.assembly(), held);
  const auto* found = std::get_if<simulation::Performance>(&performance);
  return found == nullptr ? std::nullopt : std::optional(found->gripping.heat);
}

}  // namespace coilwright::systems::gripper
