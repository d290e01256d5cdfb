#include "coilwright/formats/data/residual_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::Replay;
using measurement::data::ChannelKind;

// Which of the three columns holds the place of a sample.
enum class Axis { time, angle, current };

Axis axis_of(const Replay& replay) {
  if (replay.kind == ChannelKind::torque) return Axis::angle;
  if (replay.kind == ChannelKind::force) return Axis::current;
  return Axis::time;
}

CsvCell residual_cell(double value, std::string_view column) {
  if (!std::isfinite(value)) return {};
  return units::from_si(value, units::difference_unit(column)) + 0.0;  // no -0
}

bool has_correction(const Replay& replay) {
  return !replay.corrected.empty();
}

void check(const Replay& replay) {
  const std::size_t samples = replay.measured.size();
  for (const std::vector<double>* each :
       {&replay.at, &replay.declared, &replay.before, &replay.after, &replay.corrected})
    if (each->size() != samples && !(each == &replay.corrected && each->empty()))
      throw std::invalid_argument(fmt::format("replay of {} in {}: vectors must be {} long; got {}", replay.channel,
                                              replay.run, samples, each->size()));
  if (!replay.left_out.empty() && replay.left_out.size() != samples)
    throw std::invalid_argument(fmt::format("replay of {} in {}: left_out must be empty or {} long; got {}",
                                            replay.channel, replay.run, samples, replay.left_out.size()));
}

}  // namespace

void write_residuals(std::ostream& out, std::span<const Replay> replays) {
  for (const Replay& replay : replays) check(replay);
  std::vector<std::string> columns{"run",      "role",     "channel",  "time_s", "angle_deg", "current_A",
                                   "left_out", "measured", "declared", "before", "after"};
  const bool corrected = std::ranges::any_of(replays, has_correction);
  if (corrected) columns.emplace_back("corrected");
  CsvWriter csv(out, columns);
  for (const Replay& replay : replays) {
    const Axis axis = axis_of(replay);
    const auto at = [&](Axis column, std::string_view name, double value) {
      return column == axis ? residual_cell(value, name) : CsvCell();
    };
    for (std::size_t i = 0; i < replay.measured.size(); ++i) {
      std::vector<CsvCell> row{replay.run,
                               replay.validate ? "validate" : "fit",
                               replay.channel,
                               at(Axis::time, "time_s", replay.at[i]),
                               at(Axis::angle, "angle_deg", replay.at[i]),
                               at(Axis::current, "current_A", replay.at[i]),
                               replay.left_out.empty() || replay.left_out[i] == 0 ? 0.0 : 1.0,
                               residual_cell(replay.measured[i], replay.channel),
                               residual_cell(replay.declared[i], replay.channel),
                               residual_cell(replay.before[i], replay.channel),
                               residual_cell(replay.after[i], replay.channel)};
      if (corrected)
        row.push_back(has_correction(replay) ? residual_cell(replay.corrected[i], replay.channel) : CsvCell());
      csv.row(row);
    }
  }
}

}  // namespace coilwright::formats
