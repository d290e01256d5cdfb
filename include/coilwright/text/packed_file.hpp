#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace coilwright::text {

/// A file of the repository that a library or the program contains (coilwright_pack in cmake).
struct PackedFile {
  std::string_view name;  ///< "study.schema.json", "dataset/step.csv"
  std::string_view text;
};

/// The text of `name` among `files`; it must be one of them.
[[nodiscard]] inline std::string_view packed_text(std::span<const PackedFile> files, std::string_view name) {
  return std::ranges::find(files, name, &PackedFile::name)->text;
}

}  // namespace coilwright::text
