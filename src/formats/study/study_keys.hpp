#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/layout.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/study/system_block.hpp"

/// What study_file.cpp puts together: the keys of a study, each with a source of its own.
namespace coilwright::formats {

/// What a study builds from its actuator, by the keys of its blocks.
using Blocks = std::map<std::string, SystemBlock>;

/// The blocks that a study has.
[[nodiscard]] Blocks read_blocks(text::ObjectReader& in);

/// Whether a key of a study is that of a block.
[[nodiscard]] bool is_block(std::string_view key);

/// Where a name is of a block that a study lacks ("driver_voltage_V"; `known` are the numbers of those that it has) the
/// rule that says so, `needs the block "driver" in the study`; nothing for any other name.
[[nodiscard]] std::optional<std::string> missing_block(std::string_view name, const std::vector<BlockVariable>& known);

/// The key of the block that brings the quantity of that name; nothing where none does.
[[nodiscard]] std::optional<std::string_view> block_of_quantity(std::string_view name);

/// The numbers of all of them that may vary.
[[nodiscard]] std::vector<BlockVariable> variables_of(const Blocks& blocks);

/// `table` with the angles of single joints and what the blocks bring.
[[nodiscard]] simulation::QuantityTable with_quantities_of(const Blocks& blocks, simulation::QuantityTable table);

/// Throws InputError at the block of which `base` cannot be a part; `root` is the study.
void require_suitable(const Blocks& blocks, const actuator::Design& base, const text::Node& root);

/// The key "variables", with those of the study's blocks. The values of "polarity" are of a row that is read later.
[[nodiscard]] std::vector<sizing::StudyVariable> read_variables(const text::Node& node,
                                                                const std::vector<BlockVariable>& of_blocks);

/// The variable "polarity": the row of the study's own actuator, built in otherwise: [[1, 1, 1], [1, -1, 1]].
[[nodiscard]] sizing::LayoutVariable read_polarities(const text::Node& node, const actuator::Layout& base);

/// The quantities of a study while it is read.
struct StudyQuantities {
  simulation::QuantityTable known;   ///< by name: the table of the reader, and what the study's blocks bring
  simulation::QuantityTable listed;  ///< what results list: the reader's table, and of the rest what was asked for
  std::optional<sizing::SpreadQuantities> spread;  ///< of a study that has one: statistics of all that is known
  /// By its name, what an expression of statistics is in one build: the same of what they are statistics of.
  std::map<std::string, simulation::ResultQuantity> of_builds{};
};

/// The key "objectives".
[[nodiscard]] std::vector<sizing::StudyObjective> read_objectives(const text::Node& node, StudyQuantities& quantities);

/// The key "constraints".
[[nodiscard]] std::vector<sizing::Limit> read_limits(const text::Node& node, StudyQuantities& quantities);

/// The key "columns": quantities that results list though nothing asks for them.
void read_columns(const text::Node& node, StudyQuantities& quantities);

/// The key "spread" of a study, with the numbers of blocks that may scatter too; `posterior` in place of the file that
/// it names, or nullptr.
[[nodiscard]] sizing::Spread read_spread(const text::Node& node, const std::vector<BlockVariable>& of_blocks,
                                         const text::InputText* posterior = nullptr);

/// Throws InputError where a number of `base`, of its effects or of a block would leave its range in one of 10,000
/// builds, where it has no such effect, and where a posterior is of other numbers than its. `node` is the key "spread".
void require_suits(const text::Node& node, const sizing::Spread& spread, const actuator::Design& base,
                   const std::vector<BlockVariable>& of_blocks);

/// The study's file with the numbers and words of those changes. Throws InputError of the argument where it is not of
/// the kind that stands there, or leads to nothing.
[[nodiscard]] text::Document changed(text::Document document, const StudyChanges& changes);

/// The study's actuator with the other changes; `root` is the study. Throws InputError where one sets what the study
/// varies, which the search would set again, or what stands in the study's own file, with its pointer, and as
/// with_assignment().
[[nodiscard]] actuator::Design changed(actuator::Design design, const sizing::Study& study, const text::Node& root,
                                       const StudyChanges& changes);

}  // namespace coilwright::formats
