#pragma once

#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// The block "driver" of a study: the pulsed supply of its coils. Its keys are in docs/formats-study.md.
[[nodiscard]] SystemBlock read_driver_block(const text::Node& node);

}  // namespace coilwright::formats
