#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A dataset.json made from what files of records look like.
struct DatasetDraft {
  text::Json document{};
  std::vector<std::string> guessed{};  ///< what a person should check, a sentence each
  std::vector<std::string>
      asked{};  ///< what only a person knows, a sentence each; without it `diagnose` refuses the set
};

/// Drafts a measured-data/1 document that stands in `folder` and names `actuator` (a path from there) and the files.
/// A layout that suits all files stands once, for the set. Throws InputError for a file that cannot be read.
[[nodiscard]] DatasetDraft draft_dataset(std::span<const std::filesystem::path> files,
                                         const std::filesystem::path& folder, const std::string& actuator);

}  // namespace coilwright::formats
