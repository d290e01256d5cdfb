#pragma once

#include <iosfwd>
#include <span>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::formats {

/// residuals.csv: a row a sample of every channel, what was measured and what the three models say, in the unit at the
/// end of the channel's name. A long table: `run, role, channel`, then where on the run's axis the sample lies
/// (`time_s`, `angle_deg` or `current_A`; the two others are empty), then `measured, declared, before, after`. A
/// prediction that does not exist (a model that left its range) is empty. Throws std::invalid_argument when the vectors
/// of a replay are not equally long.
void write_residuals(std::ostream& out, std::span<const measurement::Replay> replays);

}  // namespace coilwright::formats
