#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/text/csv/csv_form.hpp"
#include "coilwright/text/csv/csv_layout.hpp"

namespace coilwright::formats {

/// What a table seems to be, by the names, units and numbers of its columns. Nothing is certain but what has our names.
struct LayoutGuess {
  text::CsvLayout layout{};  ///< columns that have other names than ours, what is left over, a sampling rate
  measurement::data::RunKind kind{};
  measurement::data::Drive drive{};
  std::vector<std::string> guessed{};  ///< what follows from no name and no unit, a sentence each
  std::vector<std::string> asked{};    ///< what only a person knows, a sentence each
};

/// What is known of a table.
struct TableContent {
  std::optional<measurement::data::RunKind> kind{};  ///< of its run; nothing: that is guessed too
  bool input{true};                                  ///< a motion's: whether it should have the input
  bool measured{true};                               ///< the same of measured values
};

/// Guesses the layout of a table.
[[nodiscard]] LayoutGuess guess_layout(const text::CsvForm& form, const TableContent& content = {});

}  // namespace coilwright::formats
