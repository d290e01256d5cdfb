#pragma once

#include "coilwright/formats/json_node.hpp"
#include "coilwright/measurement/data/run.hpp"

namespace coilwright::formats {

/// A word that data sets and planned experiments share, as `measurement::name_of` writes it. Throws InputError with the
/// legal ones.
[[nodiscard]] measurement::data::RunKind read_run_kind(const Node& node);
[[nodiscard]] measurement::data::Drive read_drive(const Node& node);
[[nodiscard]] measurement::data::Start read_start(const Node& node);

}  // namespace coilwright::formats
