#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// front.csv, or another table of designs, with what its columns are.
struct FrontTable {
  text::CsvTexts texts;
  std::vector<std::string> variables;
  std::vector<std::string> objectives;
  std::vector<bool> largest;  ///< of each objective: whether it is to be large
  std::vector<std::string> margins;
  std::vector<std::string> quantities;  ///< all others

  [[nodiscard]] std::size_t rows() const noexcept { return texts.rows(); }
};

/// Of the folder of a `pareto`; the objectives are those of its result.json.
[[nodiscard]] FrontTable read_front(const std::filesystem::path& folder, const text::Node& result);

/// Of the folder of a `sweep`: best.csv, the best designs of each configuration, likewise.
[[nodiscard]] FrontTable read_leaders(const std::filesystem::path& folder, const text::Node& result);

/// The columns that people look at: the objectives, then the variables that are none.
[[nodiscard]] std::vector<std::string> shown_columns(const FrontTable& front);

/// The fields of a row in some columns, to read: numbers with five digits, texts as they are.
[[nodiscard]] std::vector<std::string> shown_fields(const FrontTable& front, std::size_t row,
                                                    std::span<const std::string> columns);

/// A field of a CSV file as JSON: a number where it is one, null where it is empty, else a text.
[[nodiscard]] text::Json json_of(const std::string& field);

/// The point of the search space at which a study has the variables of a row; nothing where it has no such point.
[[nodiscard]] std::optional<std::vector<double>> point_of(const sizing::Study& study, const FrontTable& front,
                                                          std::size_t row);

/// At most `most` of `count` rows, evenly, with the first and the last.
[[nodiscard]] std::vector<std::size_t> even_choice(std::size_t count, std::size_t most);

}  // namespace coilwright::page
