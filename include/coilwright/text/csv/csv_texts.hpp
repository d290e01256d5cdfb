#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// A CSV file as it stands there, column by column: for tables in which texts and numbers are mixed. Not for inputs of
/// a person, whose columns a CsvHeader checks.
class CsvTexts {
 public:
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }  ///< of the columns kept
  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  /// Whether a column of that name was kept.
  [[nodiscard]] bool has(std::string_view name) const;
  /// The fields of a column, a text a row. Throws std::out_of_range where it was not kept.
  [[nodiscard]] const std::vector<std::string>& column(std::string_view name) const;
  /// The field as a number; nothing where it is empty or no finite number.
  [[nodiscard]] std::optional<double> number(std::string_view name, std::size_t row) const;

 private:
  friend CsvTexts read_csv_texts(const std::filesystem::path& path,
                                 const std::function<bool(std::string_view name)>& keep);
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view name) const;

  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
  std::size_t rows_{};
};

/// Reads the columns of a CSV file for which `keep` says yes; the first row is the header, and there need be no other.
/// Throws InputError for a file that cannot be read or has no header, and naming the line of a row with another number
/// of fields.
[[nodiscard]] CsvTexts read_csv_texts(const std::filesystem::path& path,
                                      const std::function<bool(std::string_view name)>& keep);

/// The same row by row, for a table that need not fit into memory: `on_row` is given the fields of the columns that
/// were kept, in the order of the names that are returned; they live as long as the call. Throws as read_csv_texts().
std::vector<std::string> for_each_csv_row(const std::filesystem::path& path,
                                          const std::function<bool(std::string_view name)>& keep,
                                          const std::function<void(std::span<const std::string_view> fields)>& on_row);

/// The text of a field as a number; nothing where it is not exactly a finite one.
[[nodiscard]] std::optional<double> number_in(std::string_view field) noexcept;

}  // namespace coilwright::text
