#pragma once

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

/// Whether the field is what programs write where there was no reading: nothing, nan, NA, null, -.
[[nodiscard]] bool is_absent(std::string_view field) noexcept;

/// The field as a finite number: no locale, no hexadecimal, no blanks, a plus sign allowed, and Fortran's D for E.
[[nodiscard]] std::optional<double> number_of(std::string_view field, char decimal) noexcept;

}  // namespace coilwright::text
