#pragma once

#include <iosfwd>
#include <span>
#include <string_view>

#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/planning/next_experiment.hpp"

namespace coilwright::formats {

/// The column that holds the place of a sample of a channel: "time_s", "angle_deg" or "current_A".
[[nodiscard]] std::string_view axis_of(measurement::data::ChannelKind kind);

/// Writes residuals.csv: a row for each sample of every channel, with the measured value and those of the three models,
/// in the unit at the end of the channel's name. The columns are `run, role, channel`, the place on the run's axis
/// (`time_s`, `angle_deg` or `current_A`; the two others are empty), and `measured, declared, before, after`. A
/// prediction that does not exist (a model that left its range) is empty. Throws std::invalid_argument if the vectors
/// of a replay are not equally long.
void write_residuals(std::ostream& out, std::span<const measurement::Replay> replays);

/// Writes next_experiment.csv: the reading that each remaining explanation expects of the proposed run, a row for each
/// sample of every channel. The columns are `run, channel`, the place on the run's axis (`time_s` or `angle_deg`; the
/// other is empty), `noise` (standard deviation of one reading), and a column for each explanation, all in the unit at
/// the end of the channel's name. A column is named by its effects, joined by "+" ("no effect" without any; " (2)"
/// follows at a second one of the same effects). Throws std::invalid_argument if an explanation lacks values.
void write_expected_readings(std::ostream& out, const measurement::planning::NextExperiment& next);

}  // namespace coilwright::formats
