#pragma once

#include <vector>

#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// The key "spread" of a study: what builds of `base` differ by, with the numbers of blocks that may scatter too.
[[nodiscard]] sizing::Spread read_spread(const text::Node& node, const actuator::Design& base,
                                         const std::vector<BlockVariable>& of_blocks);

}  // namespace coilwright::formats
