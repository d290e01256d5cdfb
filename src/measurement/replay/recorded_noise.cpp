#include "measurement/replay/recorded_noise.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/algebra/least_squares.hpp"
#include "measurement/signals/noise_colour.hpp"
#include "measurement/signals/spikes.hpp"

namespace coilwright::measurement::replay {
namespace {

using signals::NoiseColour;

constexpr std::size_t fewest_still_samples = 64;
constexpr std::size_t fewest_samples_at_rest = 128;  // in all parts together
constexpr std::size_t shortest_part = 32;
// Under a constant input a finger comes to rest, or creeps; it does not hum. After so long what rang has died away.
constexpr double ringing_time = 3.0;  // s
constexpr std::size_t fewest_steady_samples = 256;
// What drifts and is not a polynomial of low degree has lines with fewer periods in the record.
constexpr double fewest_periods = 12.0;
// Intervals within this share of each other are one.
constexpr double same_interval = 0.02;

double mean_interval(const std::vector<double>& times) {
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

// A stretch of one channel in which nothing moves; its spikes have been bridged.
struct Stretch {
  std::vector<double> values{};
  double interval{};
};

std::optional<Stretch> stretch_of(const data::Run& run, data::ChannelKind kind, int joint, SampleRange range,
                                  std::size_t fewest) {
  if (range.samples() < fewest || run.times.size() < range.last) return std::nullopt;
  for (const data::Channel& channel : run.channels) {
    if (channel.kind != kind || channel.joint != joint) continue;
    std::vector<double> values(channel.values.begin() + static_cast<std::ptrdiff_t>(range.first),
                               channel.values.begin() + static_cast<std::ptrdiff_t>(range.last));
    return Stretch{.values = signals::without_spikes(std::move(values)), .interval = mean_interval(run.times)};
  }
  return std::nullopt;
}

SampleRange samples_between(const data::Run& run, double first, double last) {
  const auto from = std::lower_bound(run.times.begin(), run.times.end(), first);
  const auto to = std::upper_bound(run.times.begin(), run.times.end(), last);
  if (from >= to) return {};
  return {.first = static_cast<std::size_t>(from - run.times.begin()),
          .last = static_cast<std::size_t>(to - run.times.begin())};
}

// Without the polynomial of degree 5 that is nearest to it: what creeps, drifts or has not yet come to rest.
std::vector<double> without_drift(const std::vector<double>& values) {
  constexpr Eigen::Index powers = 6;
  const auto n = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd basis(n, powers);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < powers; ++k)  // Chebyshev polynomials: nearly orthogonal
      basis(i, k) = std::cos(static_cast<double>(k) *
                             std::acos((2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(n) - 1.0));
  const Eigen::Map<const Eigen::VectorXd> series(values.data(), n);
  const Eigen::VectorXd left = series - basis * algebra::least_squares(basis, series);
  return {left.begin(), left.end()};
}

// How far apart the clocks of the samples and of the input may be, and how long a sample is exposed, s.
double unknown_time(const data::Run& run) {
  return 4.0 * run.clock.offset_sigma + run.clock.exposure;
}

// Samples of a run before its input changes for the first time.
SampleRange samples_at_rest(const data::Run& run) {
  if (run.kind != data::RunKind::transient || run.start != data::Start::at_rest || run.inputs.empty()) return {};
  std::size_t row = 1;
  while (row < run.inputs.size() && run.inputs[row] == run.inputs.front()) ++row;
  if (row == run.inputs.size()) return {};  // nothing ever happens: there is no motion to compare it with
  return samples_between(run, run.times.front(), run.times_of_inputs()[row - 1] - unknown_time(run));
}

// Samples of a run while its input stays as it is, without those in which the finger may still ring.
std::vector<SampleRange> samples_under_constant_input(const data::Run& run) {
  std::vector<SampleRange> out;
  if (run.kind != data::RunKind::transient) return out;
  const std::vector<double>& times = run.times_of_inputs();
  for (std::size_t row = 0; row < run.inputs.size();) {
    std::size_t next = row + 1;
    while (next < run.inputs.size() && run.inputs[next] == run.inputs[row]) ++next;
    // The last row is in force to the end of the record.
    const double end = next < run.inputs.size() ? times[next - 1] - unknown_time(run) : run.times.back();
    out.push_back(samples_between(run, times[row] + unknown_time(run) + ringing_time, end));
    row = next;
  }
  return out;
}

// The colour of the longest stretches of one interval.
std::optional<NoiseColour> colour_of_all(const std::vector<Stretch>& stretches, std::size_t fewest) {
  if (stretches.empty()) return std::nullopt;
  const auto longest = std::ranges::max_element(stretches, {}, [](const Stretch& each) { return each.values.size(); });
  std::vector<signals::StillPiece> pieces;
  std::size_t samples = 0;
  for (const Stretch& each : stretches) {
    if (std::abs(each.interval / longest->interval - 1.0) > same_interval) continue;
    pieces.push_back({.values = each.values, .interval = longest->interval});
    samples += each.values.size();
  }
  if (samples < fewest) return std::nullopt;
  return signals::colour_of(pieces);
}

std::string text_of(const NoiseColour& colour, const std::string& source) {
  std::string text = colour.is_white
                         ? fmt::format("white, as {}", source)
                         : fmt::format("coloured, its spectrum from {} in {} bands", source, colour.bands.size());
  if (colour.low_end) text += fmt::format(", growing towards low frequencies as 1/f^{:.2g}", colour.low_end->exponent);
  for (const signals::NoiseLine& line : colour.lines) text += fmt::format(", hum at {:.3g} Hz", line.frequency);
  return text;
}

void take_over(PreparedRun& prepared, std::size_t channel, const NoiseColour& colour) {
  for (const signals::NoiseLine& line : colour.lines) {
    const bool known = std::ranges::any_of(prepared.lines, [&](double other) {
      return std::abs(other - line.frequency) * (prepared.run->times.back() - prepared.run->times.front()) < 1.0;
    });
    if (known) continue;
    prepared.lines.push_back(line.frequency);
    prepared.line_sizes.push_back(line.amplitude);
  }
  // Innovations of an input that is not exact are those of white noise.
  if (!colour.is_white && prepared.run->input_uncertainty.sigma.empty())
    prepared.whiteners[channel] = std::make_shared<signals::Whitener>(colour, mean_interval(prepared.run->times));
}

// Hum as the parts of the runs under a constant input show it. Not their colour: what creeps there is no noise.
void take_over_hum(PreparedRun& prepared, std::size_t c, std::span<const data::Run> runs) {
  const data::Channel& channel = prepared.run->channels[c];
  std::vector<Stretch> stretches;
  for (const data::Run& run : runs)
    for (const SampleRange& range : samples_under_constant_input(run))
      if (auto found = stretch_of(run, channel.kind, channel.joint, range, fewest_steady_samples)) {
        found->values = without_drift(found->values);
        stretches.push_back(std::move(*found));
      }
  auto colour = colour_of_all(stretches, fewest_steady_samples);
  if (!colour) return;
  double longest = 0.0;
  for (const Stretch& each : stretches)
    longest = std::max(longest, each.interval * static_cast<double>(each.values.size()));
  std::erase_if(colour->lines,
                [&](const signals::NoiseLine& line) { return line.frequency * longest < fewest_periods; });
  if (colour->lines.empty()) return;
  std::string lines;
  for (const signals::NoiseLine& line : colour->lines)
    lines += fmt::format("{}{:.3g} Hz", lines.empty() ? "" : ", ", line.frequency);
  prepared.noise[c].colour =
      fmt::format("taken as white but for hum at {}, which the parts under a constant input show: no still run", lines);
  colour->is_white = true;
  take_over(prepared, c, *colour);
}

void take_recorded_noise(PreparedRun& prepared, std::span<const data::Run> still, std::span<const data::Run> runs) {
  prepared.whiteners.assign(prepared.noise.size(), nullptr);
  prepared.lines.clear();
  prepared.line_sizes.clear();
  for (std::size_t c = 0; c < prepared.noise.size(); ++c) {
    const data::Channel& channel = prepared.run->channels[c];
    signals::NoiseLevel& level = prepared.noise[c];
    level.colour = "taken as white: there is no still run, and the parts at rest are too short to show its colour";
    level.colour_unknown = true;
    std::vector<Stretch> stretches;
    for (const data::Run& run : still)
      if (auto found = stretch_of(run, channel.kind, channel.joint, {.last = run.samples()}, fewest_still_samples))
        stretches.push_back(std::move(*found));
    if (const auto colour = colour_of_all(stretches, fewest_still_samples); colour && colour->sigma > 0.0) {
      if (!level.given) {
        level.sigma = std::max(colour->sigma, 1e-12);
        level.from_the_run = false;
        level.freedom = colour->freedom;
        level.source = fmt::format("the still run, {:.0f} samples", colour->freedom);
      }
      level.colour = text_of(*colour, "the still run");
      level.colour_unknown = false;
      take_over(prepared, c, *colour);
      continue;
    }
    for (const data::Run& run : runs)
      if (auto found = stretch_of(run, channel.kind, channel.joint, samples_at_rest(run), shortest_part))
        stretches.push_back(std::move(*found));
    const auto colour = colour_of_all(stretches, fewest_samples_at_rest);
    if (!colour || colour->sigma <= 0.0) {
      take_over_hum(prepared, c, runs);
      continue;
    }
    // A compressed film holds a picture in which nothing moves, with its errors: that is not the noise of a motion.
    if (level.given && colour->sigma < 0.5 * level.sigma) {
      level.colour =
          fmt::format("taken as white: the parts at rest scatter by {:.2g} of it, and do not show its colour",
                      colour->sigma / level.sigma);
      take_over_hum(prepared, c, runs);
      continue;
    }
    level.colour = text_of(*colour, "the parts at rest");
    level.colour_unknown = false;
    if (colour->is_white && colour->lines.empty()) continue;
    if (!level.given) {
      level.sigma = std::max(colour->sigma, 1e-12);
      level.from_the_run = false;
      level.freedom = colour->freedom;
      level.source = fmt::format("the parts at rest, {:.0f} samples", colour->freedom);
    }
    take_over(prepared, c, *colour);
  }
}

}  // namespace

void give_recorded_noise(PreparedRun& prepared, std::span<const data::Run> still, std::span<const data::Run> runs) {
  if (!prepared.is_motion()) return;
  take_recorded_noise(prepared, still, runs);
  const std::vector<double>& sigma = prepared.run->input_uncertainty.sigma;
  if (sigma.empty()) return;
  for (signals::NoiseLevel& level : prepared.noise)
    level.colour += fmt::format("; white beside the errors of the input, input_sigma {:.6g}", fmt::join(sigma, ", "));
}

}  // namespace coilwright::measurement::replay
