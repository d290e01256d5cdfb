#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// What a study builds from its actuator, by the keys of its blocks.
using Blocks = std::map<std::string, SystemBlock>;

/// The blocks that a study has.
[[nodiscard]] Blocks read_blocks(text::ObjectReader& in);

/// Whether a key of a study is that of a block.
[[nodiscard]] bool is_block(std::string_view key);

/// The key of the block that brings the quantity of that name; nothing where none does.
[[nodiscard]] std::optional<std::string_view> block_of_quantity(std::string_view name);

/// The numbers of all of them that may vary.
[[nodiscard]] std::vector<BlockVariable> variables_of(const Blocks& blocks);

/// `table` with the angles of single joints and what the blocks bring.
[[nodiscard]] simulation::QuantityTable with_quantities_of(const Blocks& blocks, simulation::QuantityTable table);

/// Throws InputError at the block of which `base` cannot be a part; `root` is the study.
void require_suitable(const Blocks& blocks, const actuator::Design& base, const text::Node& root);

}  // namespace coilwright::formats
