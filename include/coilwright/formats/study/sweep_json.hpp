#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <span>

#include "coilwright/sizing/study/broken_part_limits.hpp"
#include "coilwright/sizing/study/leaders.hpp"
#include "coilwright/sizing/study/sweep.hpp"
#include "coilwright/sizing/study/sweep_summary.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The results of `sweep` that are to be written. Everything referred to must outlive it.
struct SweepReport {
  const sizing::Study& study;
  std::size_t designs{};    ///< in the grid, or that differ in the sample
  std::size_t evaluated{};  ///< designs evaluated; fewer after an interruption
  std::size_t ok{};         ///< evaluated designs that keep every limit
  std::span<const sizing::Leader> leaders;
  std::span<const sizing::BrokenPartLimit> broken{};  ///< limits of parts that leaders break which keep every limit
  std::optional<sizing::DesignSample> sample{};       ///< absent: the grid
  sizing::Keep keep = sizing::Keep::all;
  std::span<const sizing::QuantityTotal> totals{};  ///< for each quantity of the study; empty if all rows are kept
};

/// The counts, and for each leader its configuration, variables, objectives, constraints and the limits of parts that
/// it breaks. If not all rows are kept, also the kind of those kept, and the statistics of each quantity over all
/// designs.
[[nodiscard]] text::Json to_json(const SweepReport& report);

}  // namespace coilwright::formats
