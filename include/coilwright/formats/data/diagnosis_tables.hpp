#pragma once

#include <iosfwd>
#include <span>

#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/planning/next_experiment.hpp"

namespace coilwright::formats {

/// residuals.csv: a row a sample of every channel, what was measured and what the three models say, in the unit at the
/// end of the channel's name. A long table: `run, role, channel`, then where on the run's axis the sample lies
/// (`time_s`, `angle_deg` or `current_A`; the two others are empty), then `measured, declared, before, after`. A
/// prediction that does not exist (a model that left its range) is empty. Throws std::invalid_argument when the vectors
/// of a replay are not equally long.
void write_residuals(std::ostream& out, std::span<const measurement::Replay> replays);

/// next_experiment.csv: what each explanation that is left expects of the proposed run, a row a sample of every
/// channel. A long table: `run, channel`, then where on the run's axis the sample lies (`time_s` or `angle_deg`; the
/// other is empty), `noise` (standard deviation of one reading), then a column for each explanation, all in the unit at
/// the end of the channel's name. A column is named by its effects, joined by "+" ("no effect" without any; a second
/// one of the same effects has " (2)" behind). Throws std::invalid_argument when an explanation lacks values.
void write_expected_readings(std::ostream& out, const measurement::planning::NextExperiment& next);

}  // namespace coilwright::formats
