#pragma once

#include <vector>

#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// The key "spread" of a study, with the numbers of blocks that may scatter too; `posterior` in place of the file that
/// it names, or nullptr.
[[nodiscard]] sizing::Spread read_spread(const text::Node& node, const std::vector<BlockVariable>& of_blocks,
                                         const text::InputText* posterior = nullptr);

/// Throws InputError where a number of `base`, of its effects or of a block would leave its range in one of 10,000
/// builds, where it has no such effect, and where a posterior is of other numbers than its. `node` is the key "spread".
void require_suits(const text::Node& node, const sizing::Spread& spread, const actuator::Design& base,
                   const std::vector<BlockVariable>& of_blocks);

}  // namespace coilwright::formats
