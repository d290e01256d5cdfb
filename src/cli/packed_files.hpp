#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace coilwright::cli {

/// A file of the repository that the program carries with it.
struct PackedFile {
  std::string_view name;  ///< "study.schema.json", "dataset/step.csv"
  std::string_view text;
};

/// The text of `name` among `files`, which have it.
[[nodiscard]] inline std::string_view packed_text(std::span<const PackedFile> files, std::string_view name) {
  return std::ranges::find(files, name, &PackedFile::name)->text;
}

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
