#pragma once

#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// The block "crawler" of a study: the ground, the cell, the pulses and the payload of a crawling robot. Its keys are
/// in docs/formats.md.
[[nodiscard]] SystemBlock read_crawler_block(const text::Node& node);

}  // namespace coilwright::formats
