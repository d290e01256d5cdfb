#pragma once

#include "coilwright/systems/gripper/grip_answer.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// What becomes of an object between fingers, as `grip --json` prints it. Keys end in their unit; what was not asked
/// for, or has no value for these magnets, is left out.
[[nodiscard]] text::Json to_json(const systems::gripper::GripAnswer& answer);

}  // namespace coilwright::formats
