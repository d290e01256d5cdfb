#include "measurement/planning/recorded_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/measurement/planning/instrument.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/replay/input_noise.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::planning {
namespace {

using replay::PreparedRun;

// Sum of the squared distances of the bands from a spectrum whose level is free, each with its number of coefficients.
template <class Density>
double distance(const std::vector<signals::NoiseColour::Band>& bands, const Density& density) {
  double weights = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const signals::NoiseColour::Band& band : bands) {
    if (band.density <= 0.0 || band.to <= 0.0) continue;
    const double apart = std::log(band.density / density(0.5 * (band.from + band.to)));
    weights += band.freedom;
    sum += band.freedom * apart;
    squares += band.freedom * apart * apart;
  }
  return weights > 0.0 ? squares - sum * sum / weights : 0.0;
}

struct Median {
  std::vector<double> values{};
  [[nodiscard]] double value() {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
};

// Which instrument measures a channel.
Instrument Instruments::*instrument_of(data::ChannelKind kind) {
  switch (kind) {
    case data::ChannelKind::bending_angle:
    case data::ChannelKind::joint_angle:
      break;
    case data::ChannelKind::joint_rate:
      return &Instruments::rate;
    case data::ChannelKind::torque:
      return &Instruments::torque;
    case data::ChannelKind::force:
      return &Instruments::force;
    case data::ChannelKind::temperature:
      return &Instruments::temperature;
  }
  return &Instruments::angle;
}

// How far the samples of one channel that were set aside lie from the model.
std::vector<double> sizes_of_outliers(const PreparedRun& prepared, const fit::RunFit& fitted, std::size_t channel) {
  std::vector<double> out;
  if (channel >= prepared.set_aside.size() || prepared.set_aside[channel].empty()) return out;
  const auto channels = static_cast<Eigen::Index>(prepared.run->channels.size());
  Eigen::Index at = 0;
  for (const replay::SampleRange& range : prepared.sample_ranges()) {
    const auto n = static_cast<Eigen::Index>(range.samples());
    const Eigen::VectorXd measured = replay::measured_values(*prepared.run, range);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index row = static_cast<Eigen::Index>(channel) * n + i;
      if (prepared.is_set_aside(channel, range.first + static_cast<std::size_t>(i)))
        out.push_back(std::abs(measured[row] - fitted.predictions[at + row]));
    }
    at += channels * n;
  }
  return out;
}

// The colour nearest to a spectrum, by least squares of the logarithms of its bands' densities.
NoiseColour nearest_colour(const signals::NoiseColour& recorded) {
  using enum NoiseColour::Kind;
  if (recorded.is_white || recorded.bands.empty()) return {};
  NoiseColour out;
  double least = distance(recorded.bands, [](double) { return 1.0; });
  const auto try_out = [&](NoiseColour colour, const auto& density) {
    const double apart = distance(recorded.bands, density);
    if (apart >= least) return;
    least = apart;
    out = colour;
  };
  try_out({.kind = one_over_f}, [](double frequency) { return 1.0 / frequency; });
  // Up to half the sampling rate. What lies above it is folded down: the spectrum of a low pass that is sampled is that
  // of an autoregression of first order.
  const double rate = 2.0 * recorded.bands.back().to;
  constexpr double ratio = 1.1;
  for (double corner = 0.005 * rate; corner < 0.5 * rate; corner *= ratio) {
    const double kept = std::exp(-2.0 * std::numbers::pi * corner / rate);
    try_out({.kind = low_pass, .frequency = std::round(1000.0 * corner) / 1000.0}, [&](double frequency) {
      return 1.0 / (1.0 - 2.0 * kept * std::cos(2.0 * std::numbers::pi * frequency / rate) + kept * kept);
    });
  }
  return out;
}

// One instrument, from all channels that it measured.
Instrument recorded_instrument(std::span<const PreparedRun> runs, const fit::Fit& fit,
                               Instrument Instruments::*member) {
  Instrument out;
  Median sigma;
  std::vector<double> off;
  double samples = 0.0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const PreparedRun& prepared = runs[r];
    for (std::size_t c = 0; c < prepared.noise.size(); ++c) {
      if (instrument_of(prepared.run->channels[c].kind) != member) continue;
      sigma.values.push_back(prepared.noise[c].sigma);
      if (c < prepared.whiteners.size() && prepared.whiteners[c] != nullptr)
        out.colour = nearest_colour(prepared.whiteners[c]->colour());
      if (!prepared.lines.empty() && member == &Instruments::angle) {
        out.hum_frequency = prepared.lines.front();
        out.hum = prepared.line_sizes.front();
      }
      samples += static_cast<double>(prepared.run->samples());
      if (r >= fit.runs.size()) continue;
      const std::vector<double> some = sizes_of_outliers(prepared, fit.runs[r], c);
      off.insert(off.end(), some.begin(), some.end());
    }
  }
  out.noise = sigma.value();
  if (off.empty()) return out;
  out.outlier_share = static_cast<double>(off.size()) / samples;
  out.smallest_outlier = std::ranges::min(off);
  out.largest_outlier = std::ranges::max(off);
  return out;
}

// The instruments that made these records. The noise of each is the median of what its runs have; its colour the
// nearest that an experiment can say: white, behind a low pass of first order, or 1 / f. What rounds readings is part
// of the noise.
Instruments recorded_instruments(std::span<const PreparedRun> runs, const fit::Fit& fit) {
  Instruments out;
  for (Instrument Instruments::*member :
       {&Instruments::angle, &Instruments::rate, &Instruments::torque, &Instruments::force, &Instruments::temperature})
    out.*member = recorded_instrument(runs, fit, member);
  for (const PreparedRun& prepared : runs) out.input_noise = std::max(out.input_noise, prepared.input_noise);
  return out;
}

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

}  // namespace coilwright::measurement::planning
