#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

/// Makes `text` fit for one line of a terminal: control characters, line separators and bytes that are not UTF-8 become
/// escapes (`\n`, `\x1b`), and everything beyond `longest` bytes is cut and marked with "...". A second application
/// changes nothing.
[[nodiscard]] std::string one_line(std::string_view text, std::size_t longest = 80);

/// one_line(text) between double quotes.
[[nodiscard]] std::string in_quotes(std::string_view text, std::size_t longest = 80);

/// The lines of a text without their ends; none after the last end.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

}  // namespace coilwright::text
