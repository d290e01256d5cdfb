#pragma once

#include <vector>

#include "coilwright/actuator/design/layout.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/node.hpp"
#include "formats/study/system_block.hpp"

namespace coilwright::formats {

/// The key "variables", with those of the study's blocks. The values of "polarity" are of a row that is read later.
[[nodiscard]] std::vector<sizing::StudyVariable> read_variables(const text::Node& node,
                                                                const std::vector<BlockVariable>& of_blocks);

/// The variable "polarity": the row of the study's own actuator, built in otherwise: [[1, 1, 1], [1, -1, 1]].
[[nodiscard]] sizing::LayoutVariable read_polarities(const text::Node& node, const actuator::Layout& base);

}  // namespace coilwright::formats
