#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/csv/csv_form.hpp"

namespace coilwright::formats {

/// What a column may be of.
enum class Quantity { time, current, voltage, torque, angle, rate, force, temperature, duty, position, other, none };

/// What the name of a column says.
struct ColumnWords {
  Quantity quantity{Quantity::none};
  bool by_unit{false};          ///< the unit alone says so
  std::string unit{};           ///< as our names end in it: "mA"; empty: none is named
  std::string strange_unit{};   ///< what stands in brackets like a unit and is none that we know: "gon"
  std::optional<int> number{};  ///< the last number in the name: 2 in "theta2"
  bool commanded{false};        ///< a setpoint, which need not be what acted or was measured
};

/// Reads the name of a column as people and instruments write it: "Time [s]", "Strom / mA", "CH1 (V)", "theta_2 (deg)".
[[nodiscard]] ColumnWords words_of(std::string_view name);

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

}  // namespace coilwright::formats
