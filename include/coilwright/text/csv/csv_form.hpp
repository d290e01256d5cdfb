#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/csv/csv_layout.hpp"

namespace coilwright::text {

/// Where the names and the numbers of a table are, as its first quarter of a megabyte shows.
struct CsvForm {
  char separator{','};
  char decimal{'.'};
  bool arrows{false};                              ///< "10:11:32.002 -> " in front of the rows, as a terminal writes it
  std::vector<std::string> preamble{};             ///< lines above the names, as they are
  std::vector<std::string> names{};                ///< of the columns, in UTF-8; "" where one has none
  std::size_t names_line{0};                       ///< from 1; 0: no line has the names
  std::size_t rows_line{0};                        ///< of the first row of numbers; 0: there is none
  std::size_t rows_at{0};                          ///< the byte at which it begins
  std::vector<std::vector<std::string>> sample{};  ///< fields of the first rows, of a table of numbers

  /// Whether a column has nothing in any row of the sample.
  [[nodiscard]] bool is_empty(std::size_t column) const;
};

/// Finds the form of a text. `whole`: whether it is all that the file has. A separator or decimal sign that `layout`
/// gives is taken; the lines that it skips are not looked at. Throws InputError for what is no text in UTF-8 or
/// Latin-1, has no line to read, or has numbers with commas that can mean two things.
[[nodiscard]] CsvForm find_csv_form(std::string_view text, bool whole, const std::string& file,
                                    const CsvLayout& layout);

/// The same of a file. Throws InputError also where it cannot be read.
[[nodiscard]] CsvForm read_csv_form(const std::filesystem::path& path, const CsvLayout& layout = {});

/// The bytes at the front of a file that its form is found from.
inline constexpr std::size_t csv_form_size = 1 << 18;

}  // namespace coilwright::text
