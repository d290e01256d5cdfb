#pragma once

#include <string>

#include "coilwright/systems/gripper/grip_answer.hpp"

namespace coilwright::report {

/// What becomes of the object, where the fingers press, how far it may be off, and what that does to the fingers.
[[nodiscard]] std::string to_text(const systems::gripper::GripAnswer& answer);

}  // namespace coilwright::report
