#pragma once

#include <span>

#include "coilwright/text/packed_file.hpp"

namespace coilwright::cli {

using text::packed_text;
using text::PackedFile;

/// The JSON Schemas of configs/schemas, by name.
[[nodiscard]] std::span<const PackedFile> schemas();

/// The files of configs/starts: what `init` writes.
[[nodiscard]] std::span<const PackedFile> starts();

}  // namespace coilwright::cli
