#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/text/csv/csv_form.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The probable layout of a table, from the names, units and numbers of its columns. Only columns with our names are
/// certain.
struct LayoutGuess {
  text::CsvLayout layout{};  ///< columns that have other names than ours, what is left over, a sampling rate
  measurement::data::RunKind kind{};
  measurement::data::Drive drive{};
  std::vector<std::string> guessed{};  ///< guesses that follow from no name and no unit, a sentence each
  std::vector<std::string> asked{};    ///< facts that only a person knows, a sentence each
};

/// The known content of a table.
struct TableContent {
  std::optional<measurement::data::RunKind> kind{};  ///< of its run; absent: that is guessed too
  bool input{true};                                  ///< a motion's: whether it should have the input
  bool measured{true};                               ///< whether a motion should have measured values
};

/// Guesses the layout of a table.
[[nodiscard]] LayoutGuess guess_layout(const text::CsvForm& form, const TableContent& content = {});

/// A dataset.json drafted from the files of records.
struct DatasetDraft {
  text::Json document{};
  std::vector<std::string> guessed{};  ///< guesses that a person should check, a sentence each
  std::vector<std::string>
      asked{};  ///< facts that only a person knows, a sentence each; `diagnose` refuses a set without them
};

/// Drafts a measured-data/1 document in `folder` that names `actuator` (a path from there) and the files. A layout that
/// suits all files stands once, for the set. Throws InputError for a file that cannot be read.
[[nodiscard]] DatasetDraft draft_dataset(std::span<const std::filesystem::path> files,
                                         const std::filesystem::path& folder, const std::string& actuator);

}  // namespace coilwright::formats
