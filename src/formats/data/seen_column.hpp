#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/text/csv/csv_form.hpp"
#include "formats/data/column_words.hpp"

namespace coilwright::formats {

/// What a column of the sample looks like.
struct SeenColumn {
  std::string source;  ///< its name, or its position where it has none of its own
  ColumnWords words;
  std::vector<double> values{};  ///< of the fields that are numbers
  bool stamps{};                 ///< dates and times
  bool text{};                   ///< neither, in more than half of what is filled
  bool counts{};                 ///< 0, 1, 2, ..: rows or pictures
  bool ticks{};                  ///< whole numbers, each larger than the one before: a clock or a counter
  bool increases{};
  bool taken{false};
};

/// Looks at a column of the first rows of a table.
[[nodiscard]] SeenColumn seen_column(const text::CsvForm& form, std::size_t column);

/// The unit that the numbers of a clock without one are in: those since 1970 by their size, whole ones by their steps.
[[nodiscard]] std::string clock_unit(const std::vector<double>& values);

}  // namespace coilwright::formats
