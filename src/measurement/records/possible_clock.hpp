#pragma once

#include <span>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::records {

/// Samples of a motion lie closer, s.
inline constexpr double slowest_camera = 0.5;

/// Whether samples so far apart (s) are those of a camera or of another sensor of a motion.
[[nodiscard]] bool is_of_a_camera(double interval);

/// Refuses a record whose times are no seconds by their spacing alone, whatever moves: closer than any sensor of a
/// motion gives readings, or counted by ones as pictures and rows are. Throws RecordSlip naming run, column and what
/// to write instead.
void require_possible_clock(const data::Run& run);

/// The same of each still run, whose times give the noise its colour.
void require_possible_clocks(std::span<const data::Run> still);

}  // namespace coilwright::measurement::records
