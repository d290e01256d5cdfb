#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/data/seen_column.hpp"

namespace coilwright::formats {

/// The units that the numbers of a clock without one may be in, by what they count from and by how far apart they are:
/// those since 1970, 1900 or the year 0 by their size, others by what a camera or a sensor has between two readings.
/// Empty where they count by ones, as pictures are numbered.
[[nodiscard]] std::vector<std::string_view> clock_units(const SeenColumn& column);

/// A time of which one column has the whole seconds and another the part of a second: "sec" and "nanosec" of ROS 2.
struct SplitClock {
  SeenColumn* seconds{};
  SeenColumn* part{};
  std::string_view unit{};  ///< of the part: "ns"
};

/// Finds one by names that are alike but for these words, and by the numbers.
[[nodiscard]] std::optional<SplitClock> split_clock(std::span<SeenColumn> columns);

}  // namespace coilwright::formats
