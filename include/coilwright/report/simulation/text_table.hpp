#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::report {

/// A table for a terminal: columns as wide as their widest cell, two spaces between them.
class TextTable {
 public:
  /// On which side of its column a cell stands.
  enum class Align { left, right };

  /// Every row has a cell a column.
  void row(std::vector<std::string> cells);
  /// How many rows it has.
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  /// Of the last row.
  [[nodiscard]] std::size_t columns() const { return rows_.empty() ? 0 : rows_.back().size(); }
  /// `indent` spaces before each line; columns not named in `align` are to the right.
  [[nodiscard]] std::string text(std::size_t indent, std::vector<Align> align) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// A number as a person reads it: six digits.
[[nodiscard]] std::string short_number(double value);

/// The same with its sign, "+41.2".
[[nodiscard]] std::string signed_number(double value);

/// A unit suffix as a person reads it: "deg/s" for "deg_s", "%" for "pct".
[[nodiscard]] std::string readable_unit(std::string_view suffix);

}  // namespace coilwright::report
