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

/// The page of `bench`: bench.html, bench.js and bench.css.
[[nodiscard]] std::span<const PackedFile> bench_files();

}  // namespace coilwright::cli
