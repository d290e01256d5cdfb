#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::text {

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
