#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::report {

/// A table for a terminal, with columns as wide as their widest cell and two spaces between them.
class TextTable {
 public:
  /// The side of its column on which a cell stands.
  enum class Align { left, right };

  /// Adds a row. Every row has one cell for each column.
  void row(std::vector<std::string> cells);
  /// Number of rows.
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  /// Number of columns of the last row.
  [[nodiscard]] std::size_t columns() const { return rows_.empty() ? 0 : rows_.back().size(); }
  /// The table as text, with `indent` spaces before each line. Columns without an entry in `align` are right-aligned.
  [[nodiscard]] std::string text(std::size_t indent, std::vector<Align> align) const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// A number for people, with six digits.
[[nodiscard]] std::string short_number(double value);

/// A number for people with its sign: "+41.2".
[[nodiscard]] std::string signed_number(double value);

/// A unit suffix for people: "deg/s" for "deg_s", "%" for "pct".
[[nodiscard]] std::string readable_unit(std::string_view suffix);

}  // namespace coilwright::report
