#pragma once

#include "coilwright/systems/gripper/grip_answer.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The answer of `grip --json`. Keys end in their unit. Values that were not asked for, or that these magnets do not
/// have, are left out.
[[nodiscard]] text::Json to_json(const systems::gripper::GripAnswer& answer);

}  // namespace coilwright::formats
