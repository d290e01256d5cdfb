#pragma once

#include <string>
#include <variant>
#include <vector>

#include "coilwright/text/json/json.hpp"
#include "coilwright/text/rule.hpp"
#include "coilwright/text/variant.hpp"

namespace coilwright::cli {

/// A table that a program knows: its columns and rows, for people and for programs.
struct Listing {
  /// Nothing, a number or a text.
  using Cell = text::Variant<std::monostate, double, std::string>;

  std::vector<std::string> columns;  ///< a number's column ends in its unit
  std::vector<std::vector<Cell>> rows;
};

/// Columns in line, texts to the left and numbers, with six digits, to the right; "-" where there is nothing.
[[nodiscard]] std::string to_text(const Listing& listing);

/// An array of objects by column; null where there is nothing.
[[nodiscard]] text::Json to_json(const Listing& listing);

/// A rule, "must be > 0", as a range: "> 0".
[[nodiscard]] std::string range_in_words(const text::Rule& rule);

}  // namespace coilwright::cli
