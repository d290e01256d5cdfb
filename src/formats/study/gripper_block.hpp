#pragma once

#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// The block "gripper" of a study: how fingers are mounted and what they lift. Its keys are in docs/formats.md.
[[nodiscard]] SystemBlock read_gripper_block(const text::Node& node);

}  // namespace coilwright::formats
