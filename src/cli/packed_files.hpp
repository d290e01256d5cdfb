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

/// Our own scripts and style of a report: theme.js, page.js, front.js, page.css, and figures.cjs for Node.
[[nodiscard]] std::span<const PackedFile> page_files();

/// Vega, Vega-Lite and vega-embed in the order in which they run, and licences.txt; none where the program was built
/// without.
[[nodiscard]] std::span<const PackedFile> report_libraries();

}  // namespace coilwright::cli
