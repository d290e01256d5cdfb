#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

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

}  // namespace coilwright::formats
