#pragma once

#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace coilwright::text {

/// One cell of a CSV row: empty, a number or a text. A number must be finite. It is written with the fewest digits that
/// read back as the same double, whatever the locale.
class CsvCell {
 public:
  CsvCell() = default;  ///< an empty cell: there is no value
  /// Makes a cell of a number or a text. A text is not copied and must outlive the row. @{
  CsvCell(double value) : content_(value) {}
  CsvCell(std::int64_t value) : content_(value) {}
  CsvCell(int value) : content_(static_cast<std::int64_t>(value)) {}
  CsvCell(std::size_t value) : content_(static_cast<std::int64_t>(value)) {}
  CsvCell(std::string_view text) : content_(text) {}
  CsvCell(const char* text) : content_(std::string_view(text)) {}
  CsvCell(const std::string& text) : content_(std::string_view(text)) {}
  ///@}
  /// The number, or an empty cell where there is none.
  CsvCell(const std::optional<double>& value) {
    if (value) content_ = *value;
  }

 private:
  friend class CsvWriter;
  std::variant<std::monostate, double, std::int64_t, std::string_view> content_;
};

/// Writes a CSV table row by row and keeps nothing. Names of columns carry their unit, and values are given in that
/// unit. The stream must outlive the writer.
class CsvWriter {
 public:
  /// Writes the header. Throws std::invalid_argument if there is no column or a name is empty or occurs twice.
  CsvWriter(std::ostream& out, std::vector<std::string> columns);

  /// Writes a row. Throws std::invalid_argument if the row has not one cell for each column or holds a number that is
  /// not finite; it is then not written. The stream's owner checks whether the stream accepted it.
  void row(std::span<const CsvCell> cells);
  /// Writes a row of cells that the call lists.
  void row(std::initializer_list<CsvCell> cells) { row(std::span(cells.begin(), cells.size())); }
  /// Writes a row of numbers.
  void row(std::span<const double> values);

  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return columns_; }

 private:
  void append(const CsvCell& cell, std::size_t column);
  void write_line();

  std::ostream* out_;
  std::vector<std::string> columns_;
  std::string line_;
};

}  // namespace coilwright::text
