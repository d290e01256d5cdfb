#include "coilwright/formats/data/diagnosis_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::Replay;
using measurement::data::ChannelKind;
using measurement::planning::ExpectedReading;
using measurement::planning::NextExperiment;

CsvCell cell(double value, std::string_view column) {
  return units::from_si(value, units::difference_unit(column)) + 0.0;  // no -0
}

CsvCell residual_cell(double value, std::string_view column) {
  return std::isfinite(value) ? cell(value, column) : CsvCell();
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

void check(const NextExperiment& next) {
  for (const ExpectedReading& each : next.expected) {
    bool whole = each.values.size() == next.explanations.size();
    for (const std::vector<double>& values : each.values) whole = whole && values.size() == each.at.size();
    if (!whole)
      throw std::invalid_argument(fmt::format("readings of {} in {}: each of {} explanations must have {} values",
                                              each.channel, each.run, next.explanations.size(), each.at.size()));
  }
}

std::vector<std::string> names_of(const std::vector<std::vector<std::string>>& explanations) {
  std::vector<std::string> names;
  std::map<std::string, int> seen;
  for (const std::vector<std::string>& ids : explanations) {
    const std::string name = ids.empty() ? "no effect" : fmt::format("{}", fmt::join(ids, "+"));
    const int again = ++seen[name];
    names.push_back(again == 1 ? name : fmt::format("{} ({})", name, again));
  }
  return names;
}

}  // namespace

std::string_view axis_of(ChannelKind kind) {
  if (kind == ChannelKind::torque) return "angle_deg";
  return kind == ChannelKind::force ? "current_A" : "time_s";
}

void write_residuals(std::ostream& out, std::span<const Replay> replays) {
  for (const Replay& replay : replays) check(replay);
  std::vector<std::string> columns{"run",      "role",     "channel",  "time_s", "angle_deg", "current_A",
                                   "left_out", "measured", "declared", "before", "after"};
  const bool corrected = std::ranges::any_of(replays, has_correction);
  if (corrected) columns.emplace_back("corrected");
  CsvWriter csv(out, columns);
  for (const Replay& replay : replays) {
    const auto at = [axis = axis_of(replay.kind)](std::string_view column, double value) {
      return column == axis ? residual_cell(value, column) : CsvCell();
    };
    for (std::size_t i = 0; i < replay.measured.size(); ++i) {
      std::vector<CsvCell> row{replay.run,
                               replay.validate ? "validate" : "fit",
                               replay.channel,
                               at("time_s", replay.at[i]),
                               at("angle_deg", replay.at[i]),
                               at("current_A", replay.at[i]),
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

void write_expected_readings(std::ostream& out, const NextExperiment& next) {
  check(next);
  std::vector<std::string> columns{"run", "channel", "time_s", "angle_deg", "noise"};
  for (std::string& name : names_of(next.explanations)) columns.push_back(std::move(name));
  CsvWriter csv(out, columns);
  for (const ExpectedReading& each : next.expected) {
    const bool bench = each.kind == measurement::data::ChannelKind::torque;
    for (std::size_t i = 0; i < each.at.size(); ++i) {
      std::vector<CsvCell> row{each.run, each.channel, bench ? CsvCell() : cell(each.at[i], "time_s"),
                               bench ? cell(each.at[i], "angle_deg") : CsvCell(), cell(each.noise, each.channel)};
      for (const std::vector<double>& values : each.values) row.push_back(cell(values[i], each.channel));
      csv.row(row);
    }
  }
}

}  // namespace coilwright::formats
