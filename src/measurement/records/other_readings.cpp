#include "measurement/records/other_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

#include "coilwright/units/unit.hpp"
#include "measurement/records/declared_readings.hpp"

namespace coilwright::measurement::records {
namespace {

using Of = OtherReading::Of;

// Nearer units are not told apart by readings that the model may miss by a factor of 3; and what a friction leaves of a
// torque is not told from what another unit does to an input.
constexpr double least_factor = 4.0;
constexpr double least_factor_of_input = 50.0;
constexpr double zero_degC = 273.15;  // K
constexpr std::array frame_rates = {5.0,   10.0,  12.0,  15.0,  20.0,  24.0,  25.0,  30.0,
                                    48.0,  50.0,  60.0,  90.0,  100.0, 120.0, 150.0, 200.0,
                                    240.0, 250.0, 300.0, 400.0, 480.0, 500.0, 960.0, 1000.0};

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> words = {{
    {"s", "seconds"},
    {"ms", "milliseconds"},
    {"us", "microseconds"},
    {"min", "minutes"},
    {"h", "hours"},
    {"day", "days"},
    {"deg", "degrees"},
    {"rad", "radians"},
    {"A", "amperes"},
    {"mA", "milliamperes"},
    {"V", "volts"},
    {"mV", "millivolts"},
    {"gf", "grams, the force of their weight (gf)"},
    {"kgf", "kilograms, the force of their weight (kgf)"},
    {"lbf", "pounds-force"},
    {"K", "kelvin"},
    {"degC", "degrees Celsius"},
    {"degF", "degrees Fahrenheit"},
}};

std::string in_words(std::string_view suffix) {
  const auto* const found = std::ranges::find(words, suffix, &std::pair<std::string_view, std::string_view>::first);
  return std::string(found == words.end() ? suffix : found->second);
}

// A column whose numbers are in `other` instead of `own`, if that is `least` or more, and as no unit before it.
void add_unit(std::vector<OtherReading>& out, OtherReading column, double least, std::string_view quantity,
              const units::Unit& own, const units::Unit& other) {
  column.column = fmt::format("{}_{}", quantity, own.suffix);
  column.factor = other.numerator / other.denominator * own.denominator / own.numerator;
  if (own.dimension == "temperature")  // memory has degrees Celsius
    column.offset = (column.factor - 1.0) * zero_degC + other.offset - own.offset * column.factor;
  else if (std::abs(std::log(column.factor)) < std::log(least))
    return;
  const auto is_same = [&](const OtherReading& each) {
    return each.of == column.of && each.channels == column.channels && each.position == column.position &&
           each.of_input_clock == column.of_input_clock && std::abs(each.factor / column.factor - 1.0) < 1e-9 &&
           each.offset == column.offset;
  };
  if (std::ranges::any_of(out, is_same)) return;
  column.looks_like = in_words(other.suffix);
  column.remedy = fmt::format("name the column {}_{}", quantity, other.suffix);
  out.push_back(std::move(column));
}

// A channel in every other unit of its dimension.
void add_units(std::vector<OtherReading>& out, const OtherReading& channel) {
  const auto name = units::split_unit(channel.column);
  if (!name) return;
  for (const units::Unit& other : units::all_units())
    if (other.dimension == name->unit.dimension && other.suffix != name->unit.suffix)
      add_unit(out, channel, least_factor, name->quantity, name->unit, other);
}

// Of what is no channel the record does not keep under which name it was read: it may be that of the usual unit, with
// numbers in another one, or the other way round.
void add_units_either_way(std::vector<OtherReading>& out, const OtherReading& column) {
  const auto name = units::split_unit(column.column);
  for (const units::Unit& other : units::all_units()) {
    if (other.dimension != name->unit.dimension || other.suffix == name->unit.suffix) continue;
    add_unit(out, column, least_factor_of_input, name->quantity, name->unit, other);
    add_unit(out, column, least_factor_of_input, name->quantity, other, name->unit);
  }
}

void add_sign(std::vector<OtherReading>& out, OtherReading column, std::string looks_like, std::string remedy) {
  column.factor = -1.0;
  column.looks_like = std::move(looks_like);
  column.remedy = std::move(remedy);
  out.push_back(std::move(column));
}

std::string usual_input_name(const data::Run& run) {
  switch (run.drive) {
    case data::Drive::current:
      return run.inputs.front().size() == 1 ? "current_A" : "current1_A";
    case data::Drive::voltage:
      return "voltage_V";
    case data::Drive::torque:
      break;
  }
  return "torque1_Nm";
}

void add_times(std::vector<OtherReading>& out, const data::Run& run) {
  OtherReading time{.of = Of::time, .column = "time_s"};
  for (const bool of_input : {true, false}) {
    if (!of_input && !run.has_input_clock()) break;
    time.of_input_clock = of_input;
    add_units_either_way(out, time);
  }
  time.of_input_clock = true;
  if (run.kind != data::RunKind::transient || !counts_by_ones(run)) return;
  time.counts = true;
  for (const double rate : frame_rates) {
    time.factor = 1.0 / rate;
    time.looks_like = fmt::format("frame numbers, at {:.0f} frames a second", rate);
    time.remedy = frame_remedy(rate);
    out.push_back(time);
  }
}

void add_channels(std::vector<OtherReading>& out, const data::Run& run) {
  OtherReading angles{.of = Of::channels};
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const data::Channel& channel = run.channels[c];
    if (is_angle(channel)) {
      if (angles.channels.empty()) angles.column = channel.name;
      angles.channels.push_back(c);
      continue;
    }
    const OtherReading one{.of = Of::channels, .column = channel.name, .channels = {c}};
    add_units(out, one);
    if (channel.kind != data::ChannelKind::temperature)
      add_sign(out, one, "one that is counted the other way", "turn its sign");
  }
  if (angles.channels.empty()) return;
  add_units(out, angles);
  add_sign(out, angles, "an angle that is counted the other way",
           "turn its sign: bending that opens the slits is positive");
}

}  // namespace

// Pictures that were dropped leave gaps.
bool counts_by_ones(const data::Run& run) {
  std::size_t ones = 0;
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    if (run.times[i] != std::floor(run.times[i])) return false;
    if (i > 0 && run.times[i] - run.times[i - 1] == 1.0) ++ones;
  }
  return 2 * ones >= run.times.size();
}

std::string frame_remedy(double rate) {
  return fmt::format(
      R"(tell the time from one to the next in dataset.json, "columns": {{"time_s": {{"as": "time_s", "factor": {:.9g}}}}})",
      1.0 / rate);
}

std::vector<OtherReading> other_readings(const data::Run& run) {
  std::vector<OtherReading> out;
  add_channels(out, run);
  if (!run.inputs.empty() && !run.inputs.front().empty()) {
    const OtherReading input{.of = Of::input, .column = usual_input_name(run)};
    if (run.kind == data::RunKind::transient)
      add_sign(out, input, "one of the other sign",
               "turn its sign: a positive current makes coil and magnet repel, or the leads are exchanged");
    add_units_either_way(out, input);
  }
  const auto add_position = [&](std::vector<double> data::Run::*position, const char* usual) {
    if (!(run.*position).empty())
      add_units_either_way(out, {.of = Of::positions, .column = usual, .position = position});
  };
  add_position(&data::Run::angles, "angle_deg");
  add_position(&data::Run::openings, "opening_deg");
  add_position(&data::Run::heights, "height_mm");
  if (!run.times.empty()) add_times(out, run);
  return out;
}

data::Run read_as(data::Run run, const OtherReading& reading) {
  const auto meant = [&](std::vector<double>& values) {
    for (double& value : values) value = reading.factor * value + reading.offset;
  };
  switch (reading.of) {
    case Of::channels:
      for (const std::size_t c : reading.channels) meant(run.channels[c].values);
      break;
    case Of::input:
      for (std::vector<double>& row : run.inputs) meant(row);
      break;
    case Of::positions:
      meant(run.*reading.position);
      break;
    case Of::time:
      meant(run.times);
      if (reading.of_input_clock) meant(run.input_times);
      if (run.window) *run.window *= reading.factor;
      break;
  }
  return run;
}

}  // namespace coilwright::measurement::records
