#include "formats/study/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/systems/crawl_quantities.hpp"
#include "coilwright/systems/driver_quantities.hpp"
#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::formats {
namespace {

struct KindOfBlock {
  std::string_view key;
  SystemBlock (*read)(const text::Node&);
  std::vector<std::string> (*quantities)();
};

constexpr std::array kinds_of_block{
    KindOfBlock{"gripper", &read_gripper_block,
                &names_of_quantities<systems::gripper::GripperTask, &systems::gripper::gripper_quantities>},
    KindOfBlock{"crawler", &read_crawler_block, &names_of_quantities<systems::CrawlTask, &systems::crawl_quantities>},
    KindOfBlock{"driver", &read_driver_block, &names_of_quantities<systems::DriverTask, &systems::driver_quantities>}};

}  // namespace

Blocks read_blocks(text::ObjectReader& in) {
  Blocks out;
  for (const KindOfBlock& kind : kinds_of_block)
    if (const auto node = in.find(kind.key)) out.emplace(kind.key, kind.read(*node));
  return out;
}

bool is_block(std::string_view key) {
  return std::ranges::count(kinds_of_block, key, &KindOfBlock::key) > 0;
}

std::optional<std::string_view> block_of_quantity(std::string_view name) {
  for (const KindOfBlock& kind : kinds_of_block)
    if (std::ranges::count(kind.quantities(), name) > 0) return kind.key;
  return std::nullopt;
}

std::optional<std::string> block_pointer(std::string_view name) {
  const std::string_view key = name.substr(0, name.find('_'));
  const bool of_an_effect = name.substr(0, name.find('=')).find('.') != std::string_view::npos;  // driver_saturation.
  if (key.size() == name.size() || !is_block(key) || of_an_effect) return std::nullopt;
  return fmt::format("/{}/{}", key, name.substr(key.size() + 1));
}

std::optional<std::string> missing_block(std::string_view name, const std::vector<BlockVariable>& known) {
  const std::string_view key = name.substr(0, name.find('_'));
  const auto of_block = [&](const BlockVariable& each) { return each.name.starts_with(variable_name(key, "")); };
  if (!block_pointer(name) || std::ranges::any_of(known, of_block)) return std::nullopt;
  return fmt::format("needs the block \"{}\" in the study", key);
}

std::vector<BlockVariable> variables_of(const Blocks& blocks) {
  std::vector<BlockVariable> out;
  for (const auto& [key, block] : blocks) out.insert(out.end(), block.variables.begin(), block.variables.end());
  return out;
}

simulation::QuantityTable with_quantities_of(const Blocks& blocks, simulation::QuantityTable table) {
  for (const simulation::ResultQuantity& each : simulation::joint_quantities()) table = table.with(each);
  for (const auto& [key, block] : blocks)
    for (const simulation::ResultQuantity& each : block.quantities) table = table.with(each);
  return table;
}

void require_suitable(const Blocks& blocks, const actuator::Design& base, const text::Node& root) {
  for (const auto& [key, block] : blocks) {
    try {
      block.require_suitable(base);
    } catch (const std::invalid_argument& rule) {
      throw root.find(key)->error_without_value(rule.what());
    }
  }
}

}  // namespace coilwright::formats
