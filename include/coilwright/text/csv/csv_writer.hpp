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

/// One cell of a CSV row: empty, a number or a text. A number is written with the fewest digits that read back as the
/// same double, whatever the locale; it must be finite.
class CsvCell {
 public:
  CsvCell() = default;  ///< an empty cell: there is no value
  /// A number or a text. A text is not copied: it must outlive the row.
  ///@{
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

/// Writes a CSV table row by row: what has been written is not kept. Columns carry their unit in their name, and the
/// values are given in that unit. The stream must outlive the writer.
class CsvWriter {
 public:
  /// Writes the header. Throws std::invalid_argument when there is no column or a name is empty or there twice.
  CsvWriter(std::ostream& out, std::vector<std::string> columns);

  /// Throws std::invalid_argument when the row has not one cell for each column or holds a number that is not finite.
  /// The row is then not written. Whether the stream took it is for the stream's owner to ask.
  void row(std::span<const CsvCell> cells);
  /// The same for cells listed at the call.
  void row(std::initializer_list<CsvCell> cells) { row(std::span(cells.begin(), cells.size())); }
  /// A row of numbers.
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
