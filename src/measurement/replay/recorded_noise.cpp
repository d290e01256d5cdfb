#include "measurement/replay/recorded_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measurement/noise/noise_colour.hpp"
#include "measurement/noise/spikes.hpp"

namespace coilwright::measurement::replay {
namespace {

using noise::NoiseColour;

constexpr std::size_t fewest_still_samples = 64;
constexpr std::size_t fewest_samples_at_rest = 128;  // in all parts together
constexpr std::size_t shortest_part = 32;
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

std::optional<Stretch> stretch_of(const data::Run& run, data::ChannelKind kind, int joint, std::size_t samples,
                                  std::size_t fewest) {
  if (samples < fewest || run.times.size() < samples) return std::nullopt;
  for (const data::Channel& channel : run.channels) {
    if (channel.kind != kind || channel.joint != joint) continue;
    std::vector<double> values(channel.values.begin(), channel.values.begin() + static_cast<std::ptrdiff_t>(samples));
    return Stretch{.values = noise::without_spikes(std::move(values)), .interval = mean_interval(run.times)};
  }
  return std::nullopt;
}

// Samples of a run before its input changes for the first time.
std::size_t samples_at_rest(const data::Run& run) {
  if (run.kind != data::RunKind::transient || run.start != data::Start::at_rest || run.inputs.empty()) return 0;
  std::size_t row = 1;
  while (row < run.inputs.size() && run.inputs[row] == run.inputs.front()) ++row;
  if (row == run.inputs.size()) return 0;  // nothing ever happens: there is no motion to compare it with
  const double last = run.times_of_inputs()[row - 1] - 4.0 * run.clock.offset_sigma - run.clock.exposure;
  return static_cast<std::size_t>(std::upper_bound(run.times.begin(), run.times.end(), last) - run.times.begin());
}

// The colour of the longest stretches of one interval.
std::optional<NoiseColour> colour_of_all(const std::vector<Stretch>& stretches, std::size_t fewest) {
  if (stretches.empty()) return std::nullopt;
  const auto longest = std::ranges::max_element(stretches, {}, [](const Stretch& each) { return each.values.size(); });
  std::vector<noise::StillPiece> pieces;
  std::size_t samples = 0;
  for (const Stretch& each : stretches) {
    if (std::abs(each.interval / longest->interval - 1.0) > same_interval) continue;
    pieces.push_back({.values = each.values, .interval = longest->interval});
    samples += each.values.size();
  }
  if (samples < fewest) return std::nullopt;
  return noise::colour_of(pieces);
}

std::string text_of(const NoiseColour& colour, const std::string& source) {
  std::string text = colour.is_white
                         ? fmt::format("white, as {}", source)
                         : fmt::format("coloured, its spectrum from {} in {} bands", source, colour.bands.size());
  for (const noise::NoiseLine& line : colour.lines) text += fmt::format(", hum at {:.3g} Hz", line.frequency);
  return text;
}

void take_over(PreparedRun& prepared, std::size_t channel, const NoiseColour& colour) {
  for (const noise::NoiseLine& line : colour.lines) {
    const bool known = std::ranges::any_of(prepared.lines, [&](double other) {
      return std::abs(other - line.frequency) * (prepared.run->times.back() - prepared.run->times.front()) < 1.0;
    });
    if (known) continue;
    prepared.lines.push_back(line.frequency);
    prepared.line_sizes.push_back(line.amplitude);
  }
  if (!colour.is_white)
    prepared.whiteners[channel] = std::make_shared<noise::Whitener>(colour, mean_interval(prepared.run->times));
}

}  // namespace

void give_recorded_noise(PreparedRun& prepared, std::span<const data::Run> still, std::span<const data::Run> runs) {
  if (!prepared.is_motion()) return;
  prepared.whiteners.assign(prepared.noise.size(), nullptr);
  prepared.lines.clear();
  prepared.line_sizes.clear();
  for (std::size_t c = 0; c < prepared.noise.size(); ++c) {
    const data::Channel& channel = prepared.run->channels[c];
    noise::NoiseLevel& level = prepared.noise[c];
    level.colour = "taken as white: there is no still run, and the parts at rest are too short to show its colour";
    std::vector<Stretch> stretches;
    for (const data::Run& run : still)
      if (auto found = stretch_of(run, channel.kind, channel.joint, run.samples(), fewest_still_samples))
        stretches.push_back(std::move(*found));
    if (const auto colour = colour_of_all(stretches, fewest_still_samples); colour && colour->sigma > 0.0) {
      if (!level.given) {
        level.sigma = std::max(colour->sigma, 1e-12);
        level.from_the_run = false;
        level.freedom = colour->freedom;
        level.source = fmt::format("the still run, {:.0f} samples", colour->freedom);
      }
      level.colour = text_of(*colour, "the still run");
      take_over(prepared, c, *colour);
      continue;
    }
    for (const data::Run& run : runs)
      if (auto found = stretch_of(run, channel.kind, channel.joint, samples_at_rest(run), shortest_part))
        stretches.push_back(std::move(*found));
    const auto colour = colour_of_all(stretches, fewest_samples_at_rest);
    if (!colour || colour->sigma <= 0.0) continue;
    level.colour = text_of(*colour, "the parts at rest");
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

}  // namespace coilwright::measurement::replay
