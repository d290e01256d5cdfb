#pragma once

#include <optional>

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/systems/gripper/grip_answer.hpp"
#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::systems::gripper {

/// What becomes of the object of a task, as the other grip(): at `current` (A) or else at that of the actuator's
/// operating point or of the paper's demonstrations, 1.4 A, with the supply of that point. A least current is looked
/// for up to task.most_current, a least friction up to `most_friction`; 0: not asked for.
[[nodiscard]] GripAnswer grip(const actuator::Design& design, const GripperTask& task,
                              const std::optional<double>& current,
                              const std::optional<actuator::OperatingPoint>& point, double most_friction);

}  // namespace coilwright::systems::gripper
