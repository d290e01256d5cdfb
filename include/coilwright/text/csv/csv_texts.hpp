#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/number.hpp"

namespace coilwright::text {

/// The fields of a CSV file, column by column, for tables that mix texts and numbers. Not for inputs of a person, whose
/// columns a CsvHeader checks.
class CsvTexts {
 public:
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }  ///< of the columns kept
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  /// Whether a column of that name was kept.
  [[nodiscard]] bool has(std::string_view name) const;
  /// The fields of a column, a text for each row. Throws InputError if no column of that name was kept.
  [[nodiscard]] const std::vector<std::string>& column(std::string_view name) const;
  /// The field as a number; absent if it is empty. Throws InputError if it is no finite number.
  [[nodiscard]] std::optional<double> number(std::string_view name, std::size_t row) const;
  /// The field as a number, which must not be empty.
  [[nodiscard]] double required_number(std::string_view name, std::size_t row) const;
  /// An error of the reader about the file as a whole.
  [[nodiscard]] InputError error(std::string rule) const;
  /// An error about one field of it.
  [[nodiscard]] InputError error(std::string_view name, std::size_t row, std::string rule) const;

 private:
  friend CsvTexts read_csv_texts(const std::filesystem::path& path,
                                 const std::function<bool(std::string_view name)>& keep);
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view name) const;

  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
  std::vector<std::uint32_t> lines_;  // of each row in the file
};

/// Reads the columns of a CSV file for which `keep` returns true; the first row is the header, and no other row is
/// required. Throws InputError for a file that cannot be read, has no header or does not end with a line end, as a
/// truncated one, and names the line of a row with another number of fields.
[[nodiscard]] CsvTexts read_csv_texts(const std::filesystem::path& path,
                                      const std::function<bool(std::string_view name)>& keep);

/// Reads them row by row, for a table that need not fit into memory: `on_row` gets the fields of the kept columns, in
/// the order of the returned names, and their line; they live as long as the call. Throws as read_csv_texts().
std::vector<std::string> for_each_csv_row(
    const std::filesystem::path& path, const std::function<bool(std::string_view name)>& keep,
    const std::function<void(std::span<const std::string_view> fields, std::size_t line)>& on_row);

/// The number in a field; absent if the field is empty. Throws InputError that names its place if it is no finite
/// number.
[[nodiscard]] std::optional<double> number_or_nothing(std::string_view field, const std::string& file, std::size_t line,
                                                      std::string_view column);

}  // namespace coilwright::text
