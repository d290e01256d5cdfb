#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// The fields of one line, whose quotes need not fit; a separator ' ' is any number of blanks.
[[nodiscard]] std::vector<std::string> fields_of(std::string_view line, char separator);

/// A line whose columns are separated by blanks, with one separator that libcsv can cut at in their place.
[[nodiscard]] std::string cut_at_blanks(std::string_view line);

/// A line with the separator in place of the arrow that a terminal puts behind the time of day: "10:11:32.002 -> 1,2".
[[nodiscard]] std::string without_arrow(std::string_view line, char separator);

/// What stands between columns that cut_at_blanks() cut: the unit separator of ASCII.
inline constexpr char blank_cut = '\x1f';

/// Whether a spreadsheet takes a text for a formula, and does what it says: one that begins with = + - @, a tab or a
/// line end, behind any number of apostrophes. CsvWriter puts an apostrophe before such a text, which a spreadsheet
/// takes for a text then, and CsvParser takes it away.
[[nodiscard]] bool begins_a_formula(std::string_view text) noexcept;

/// A field as CsvWriter got it.
[[nodiscard]] std::string_view without_guard(std::string_view field) noexcept;

/// Whether the field is what programs write where there was no reading: nothing, nan, NA, null, -.
[[nodiscard]] bool is_absent(std::string_view field) noexcept;

/// The field as a finite number: no locale, no hexadecimal, no blanks, a plus sign allowed, and Fortran's D for E.
[[nodiscard]] std::optional<double> number_of(std::string_view field, char decimal) noexcept;

/// A line above the numbers.
struct NamesLine {
  std::string_view text;
  std::size_t number{};  ///< from 1
};

/// What the columns of a table are called.
struct ColumnNames {
  std::vector<std::string> names{};  ///< in UTF-8; empty where no line has them
  std::size_t line{0};               ///< the last one that has a part of them; 0: none
  std::size_t first{0};              ///< how many lines stand above the first one
};

/// Finds the names among the lines above the first row of numbers, which has `width` fields: the last line that is not
/// blank and has as many or more. One that begins with # or % counts where no other has. A row of units, and the rows
/// of DeepLabCut, join the names above them.
[[nodiscard]] ColumnNames find_names(const std::vector<NamesLine>& above, std::size_t width, char separator);

/// Text that is no UTF-8 taken for Latin-1, as older programs write a degree sign.
[[nodiscard]] std::string in_utf8(std::string_view text);

}  // namespace coilwright::text
