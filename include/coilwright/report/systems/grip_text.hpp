#pragma once

#include <string>

#include "coilwright/systems/gripper/grip_answer.hpp"

namespace coilwright::report {

/// The answer of `grip`: whether the object is held, where the fingers press, the tolerance of placement, and the heat
/// of the fingers.
[[nodiscard]] std::string to_text(const systems::gripper::GripAnswer& answer);

}  // namespace coilwright::report
