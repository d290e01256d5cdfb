#include "measurement/experiment/recorded_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "measurement/experiment/recorded_instruments.hpp"
#include "measurement/replay/input_noise.hpp"

namespace coilwright::measurement::experiment {
namespace {

using replay::PreparedRun;
using Rows = std::vector<std::vector<double>>;

// A longer table belongs into a file of its own.
constexpr std::size_t longest_table = 5000;

double significant(double value, double digits) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1.0);
  return std::round(value / unit) * unit;
}

double mean_rate(const std::vector<double>& times) {
  return significant(static_cast<double>(times.size() - 1) / (times.back() - times.front()), 9.0);
}

// When a level began that sample `i` is the first to have, from the start of the run: a little before the sample, or in
// the middle where the input is known at its samples only.
double beginning_of(const data::Run& run, std::size_t i) {
  const std::vector<double>& times = run.times_of_inputs();
  const double interval = times[i] - times[i - 1];
  const double before = run.hold == data::InputHold::unknown_within_sample ? 0.5 : 0.01;
  const double unit = std::pow(10.0, std::floor(std::log10(interval)) - 3.0);
  return unit * std::round((times[i] - before * interval - run.times.front()) / unit);
}

// The levels of the input, each with the time from which it is held; those before the run are its first one.
TableShape levels_of(const data::Run& run, const Rows& rows) {
  TableShape out{.times = {0.0}, .rows = {rows.front()}};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i] == out.rows.back()) continue;
    const double begins = beginning_of(run, i);
    if (begins >= run.times.back() - run.times.front()) break;
    if (begins <= out.times.back()) {
      out.rows.back() = rows[i];
    } else {
      out.times.push_back(begins);
      out.rows.push_back(rows[i]);
    }
  }
  return out;
}

InputShape shape_of(TableShape table) {
  const bool for_all = table.rows.front().size() == 1;
  const auto level = [&](std::size_t i) { return table.rows[i][0]; };
  if (for_all && table.rows.size() == 1) return StepShape{.before = level(0), .after = level(0)};
  if (for_all && table.rows.size() == 2) return StepShape{.before = level(0), .after = level(1), .at = table.times[1]};
  if (for_all && table.rows.size() == 3 && level(0) == 0.0 && level(2) == 0.0)
    return HoldShape{.level = level(1), .from = table.times[1], .until = table.times[2]};
  return table;
}

PlannedRun planned(const PreparedRun& prepared) {
  const data::Run& run = *prepared.run;
  PlannedRun out;
  out.plan = {.name = std::filesystem::path(run.name).filename().replace_extension(".csv").string(),
              .kind = run.kind,
              .drive = run.drive,
              .start = run.start,
              .clock = run.clock,
              .hold = run.hold,
              .rig = run.rig,
              .input_uncertainty = run.input_uncertainty};
  constexpr double largest_rate_difference = 0.2;  // that an experiment may have
  out.plan.clock.rate_sigma = std::min(run.clock.rate_sigma, largest_rate_difference);
  for (const data::Channel& channel : run.channels)
    out.plan.channels.push_back({.name = channel.name, .kind = channel.kind, .joint = channel.joint});
  out.duration = significant(run.times.back() - run.times.front(), 9.0);
  out.rate = mean_rate(run.times);
  if (run.has_input_clock() && run.input_times.size() > 1) out.input_rate = mean_rate(run.input_times);
  const auto clean = replay::without_noise(run);
  out.input = shape_of(levels_of(run, clean ? clean->rows : run.inputs));
  return out;
}

}  // namespace

Experiment recorded_experiment(std::span<const PreparedRun> runs, const fit::Fit& fit) {
  Experiment out{.name = "recorded", .instruments = recorded_instruments(runs, fit), .runs = {}};
  for (const PreparedRun& prepared : runs)
    if (prepared.is_motion() && prepared.run->samples() > 1) out.runs.push_back(planned(prepared));
  return out;
}

bool can_be_repeated(const PlannedRun& recorded) {
  const auto* table = std::get_if<TableShape>(&recorded.input);
  return recorded.plan.start == data::Start::at_rest && (table == nullptr || table->rows.size() <= longest_table);
}

}  // namespace coilwright::measurement::experiment
