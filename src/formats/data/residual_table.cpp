#include "coilwright/formats/data/residual_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
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

CsvCell cell(double value, std::string_view column) {
  if (!std::isfinite(value)) return {};
  return units::from_si(value, units::difference_unit(column)) + 0.0;  // no -0
}

void check(const Replay& replay) {
  const std::size_t samples = replay.measured.size();
  for (const std::vector<double>* each : {&replay.at, &replay.declared, &replay.before, &replay.after})
    if (each->size() != samples)
      throw std::invalid_argument(fmt::format("replay of {} in {}: vectors must be {} long; got {}", replay.channel,
                                              replay.run, samples, each->size()));
}

}  // namespace

void write_residuals(std::ostream& out, std::span<const Replay> replays) {
  for (const Replay& replay : replays) check(replay);
  CsvWriter csv(
      out, {"run", "role", "channel", "time_s", "angle_deg", "current_A", "measured", "declared", "before", "after"});
  for (const Replay& replay : replays) {
    const Axis axis = axis_of(replay);
    const auto at = [&](Axis column, std::string_view name, double value) {
      return column == axis ? cell(value, name) : CsvCell();
    };
    for (std::size_t i = 0; i < replay.measured.size(); ++i)
      csv.row({replay.run, replay.validate ? "validate" : "fit", replay.channel, at(Axis::time, "time_s", replay.at[i]),
               at(Axis::angle, "angle_deg", replay.at[i]), at(Axis::current, "current_A", replay.at[i]),
               cell(replay.measured[i], replay.channel), cell(replay.declared[i], replay.channel),
               cell(replay.before[i], replay.channel), cell(replay.after[i], replay.channel)});
  }
}

}  // namespace coilwright::formats
