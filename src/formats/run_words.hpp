#pragma once

#include "coilwright/formats/json_node.hpp"
#include "coilwright/measurement/dataset.hpp"

namespace coilwright::formats {

/// A word that data sets and planned experiments share, as `measurement::name_of` writes it. Throws InputError with the
/// legal ones.
[[nodiscard]] measurement::RunKind read_run_kind(const Node& node);
[[nodiscard]] measurement::Drive read_drive(const Node& node);
[[nodiscard]] measurement::Start read_start(const Node& node);

}  // namespace coilwright::formats
