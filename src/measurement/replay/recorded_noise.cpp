#include "measurement/replay/recorded_noise.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/algebra/least_squares.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/simulation/modes.hpp"
#include "measurement/replay/input_rows.hpp"
#include "measurement/replay/rig_change.hpp"
#include "measurement/signals/noise_colour.hpp"
#include "measurement/signals/spikes.hpp"

namespace coilwright::measurement::replay {
namespace {

using signals::NoiseColour;

constexpr std::size_t fewest_still_samples = 64;
constexpr std::size_t fewest_samples_at_rest = 128;  // in all parts together
constexpr std::size_t shortest_part = 32;
constexpr std::size_t fewest_steady_samples = 256;
// A model stands still where it is no further than this share of the noise from a drift: nobody would see it move.
constexpr double still_over_noise = 0.1;
// A part that begins with motion is shortened from its start, by so many parts of its length at a time.
constexpr std::size_t shortenings = 16;
// A line that is no further from a natural frequency of the model than this share of it is a swing and no hum: what a
// model lacks, or the size of the swing, may change its frequency by so much.
constexpr double frequency_unknown = 0.1;
// A mode that is damped more has no peak in its response.
constexpr double most_damped = 0.5 * std::numbers::sqrt2;
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

const Stretch& longest_of(const std::vector<Stretch>& stretches) {
  return *std::ranges::max_element(stretches, {}, [](const Stretch& each) { return each.values.size(); });
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

// Samples of a run while its input stays as it is, and the row of the input that is in force there.
struct SteadyPart {
  SampleRange range{};
  std::size_t row{};
};

std::vector<SteadyPart> parts_under_constant_input(const data::Run& run) {
  std::vector<SteadyPart> out;
  if (run.kind != data::RunKind::transient) return out;
  const std::vector<double>& times = run.times_of_inputs();
  for (std::size_t row = 0; row < run.inputs.size();) {
    std::size_t next = row + 1;
    while (next < run.inputs.size() && run.inputs[next] == run.inputs[row]) ++next;
    // The last row is in force to the end of the record.
    const double end = next < run.inputs.size() ? times[next - 1] - unknown_time(run) : run.times.back();
    const SampleRange range = samples_between(run, times[row] + unknown_time(run), end);
    if (range.samples() >= fewest_steady_samples) out.push_back({.range = range, .row = row});
    row = next;
  }
  return out;
}

// The end of a stretch in which a motion does nothing but drift; a constant input alone is no proof of that. Empty
// where it is too short.
SampleRange where_it_stands_still(const Eigen::Ref<const Eigen::VectorXd>& motion, SampleRange range, double most) {
  const std::size_t step = std::max<std::size_t>(1, range.samples() / shortenings);
  for (; range.first + fewest_steady_samples <= range.last; range.first += step) {
    const auto part = motion.tail(static_cast<Eigen::Index>(range.samples()));
    const std::vector<double> moves = without_drift({part.begin(), part.end()});
    if (std::ranges::all_of(moves, [&](double each) { return std::abs(each) <= most; })) return range;
  }
  return {};
}

// A run beside what its instruments show of the fitted model.
struct FittedMotion {
  const PreparedRun* prepared{};
  const Eigen::VectorXd& shown;
};

// The parts of a motion under a constant input in which the fitted model, too, stands still, in one channel.
std::vector<SampleRange> parts_at_rest(const FittedMotion& motion, std::size_t channel) {
  std::vector<SampleRange> out;
  const double most = still_over_noise * motion.prepared->noise[channel].sigma;
  for (const SteadyPart& part : parts_under_constant_input(*motion.prepared->run)) {
    Eigen::Index at = 0;
    for (const SampleRange window : motion.prepared->sample_ranges()) {
      const SampleRange both{.first = std::max(part.range.first, window.first),
                             .last = std::min(part.range.last, window.last)};
      const auto samples = static_cast<Eigen::Index>(window.samples());
      const Eigen::Index of_channel = at + static_cast<Eigen::Index>(channel) * samples;
      at += motion.prepared->values_in(window);
      if (both.first >= both.last || both.samples() < fewest_steady_samples) continue;
      const auto shown = motion.shown.segment(of_channel + static_cast<Eigen::Index>(both.first - window.first),
                                              static_cast<Eigen::Index>(both.samples()));
      if (const SampleRange still = where_it_stands_still(shown, both, most); still.samples() > 0) out.push_back(still);
    }
  }
  return out;
}

// Natural frequencies of what rings of a model, Hz, about where it rests under a row of a run's input.
void add_swings(const actuator::Model& model, const data::Run& run, std::vector<double> row, std::vector<double>& out) {
  data::Run held{.kind = run.kind, .drive = run.drive};
  held.times = {0.0};
  held.inputs = {std::move(row)};
  const simulation::ModelInput input = simulation::model_input(model, held.command());
  const auto rest = simulation::equilibrium_at_first_input(model, input);
  if (!rest) return;
  for (const simulation::Mode& mode : simulation::modes(model, rest->angles, input.currents.front()))
    if (mode.natural_frequency > 0.0 && mode.damping_ratio < most_damped) out.push_back(mode.natural_frequency);
}

// At which frequencies a model swings, Hz: by itself, and under what is held in each run, on the rig of that run.
std::vector<double> swings_of(const actuator::Model& model, std::span<const data::Run> runs) {
  std::vector<double> out;
  for (const data::Run& run : runs) {
    if (run.kind != data::RunKind::transient) continue;
    const actuator::Model there(on_changed_rig(model.nominal_spec(), run.rig));
    add_swings(there, run, std::vector<double>(run.inputs.front().size(), 0.0), out);
    for (const SteadyPart& part : parts_under_constant_input(run)) add_swings(there, run, run.inputs[part.row], out);
  }
  return out;
}

// Where samples show a frequency, Hz: one above half of their rate as its picture below.
double as_sampled(double frequency, double interval) {
  return std::abs(frequency - std::round(frequency * interval) / interval);
}

// Everything that tells of the noise of a run.
struct Sources {
  std::span<const data::Run> still{}, runs{};
  const actuator::Model& model;
  std::span<const FittedMotion> motions{};
};

// Takes away the lines at which the model swings: they are no hum. Returns the frequency of the last; nothing: none is.
std::optional<double> without_swings(NoiseColour& colour, const std::vector<Stretch>& stretches, const Sources& from,
                                     const data::Run& own) {
  if (colour.lines.empty()) return std::nullopt;
  const Stretch& longest = longest_of(stretches);
  const double resolved = 1.0 / (longest.interval * static_cast<double>(longest.values.size()));
  const std::vector<double> swings = swings_of(from.model, from.runs.empty() ? std::span(&own, 1) : from.runs);
  std::optional<double> found;
  std::erase_if(colour.lines, [&](const signals::NoiseLine& line) {
    const bool is_swing = std::ranges::any_of(swings, [&](double swing) {
      const double apart = std::abs(as_sampled(swing, longest.interval) - line.frequency);
      return apart <= std::max(frequency_unknown * swing, resolved);
    });
    if (is_swing) found = line.frequency;
    return is_swing;
  });
  return found;
}

// The colour of the longest stretches of one interval.
std::optional<NoiseColour> colour_of_all(const std::vector<Stretch>& stretches, std::size_t fewest) {
  if (stretches.empty()) return std::nullopt;
  const double interval = longest_of(stretches).interval;
  std::vector<signals::StillPiece> pieces;
  std::size_t samples = 0;
  for (const Stretch& each : stretches) {
    if (std::abs(each.interval / interval - 1.0) > same_interval) continue;
    pieces.push_back({.values = each.values, .interval = interval});
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

// Hum as the parts of the runs show it that are under a constant input, and in which the fitted model stands still. Not
// their colour: what creeps there is no noise.
void take_over_hum(PreparedRun& prepared, std::size_t c, const Sources& from) {
  const data::Channel& channel = prepared.run->channels[c];
  std::vector<Stretch> stretches;
  for (const FittedMotion& motion : from.motions) {
    const std::vector<data::Channel>& channels = motion.prepared->run->channels;
    for (std::size_t other = 0; other < channels.size(); ++other) {
      if (channels[other].kind != channel.kind || channels[other].joint != channel.joint) continue;
      for (const SampleRange& range : parts_at_rest(motion, other))
        if (auto found = stretch_of(*motion.prepared->run, channel.kind, channel.joint, range, fewest_steady_samples)) {
          found->values = without_drift(found->values);
          stretches.push_back(std::move(*found));
        }
    }
  }
  auto colour = colour_of_all(stretches, fewest_steady_samples);
  if (!colour) return;
  double longest = 0.0;
  for (const Stretch& each : stretches)
    longest = std::max(longest, each.interval * static_cast<double>(each.values.size()));
  std::erase_if(colour->lines,
                [&](const signals::NoiseLine& line) { return line.frequency * longest < fewest_periods; });
  (void)without_swings(*colour, stretches, from, *prepared.run);
  if (colour->lines.empty()) return;
  std::string lines;
  for (const signals::NoiseLine& line : colour->lines)
    lines += fmt::format("{}{:.3g} Hz", lines.empty() ? "" : ", ", line.frequency);
  prepared.noise[c].colour =
      fmt::format("taken as white but for hum at {}, which the parts under a constant input show: no still run", lines);
  colour->is_white = true;
  take_over(prepared, c, *colour);
}

void take_level(signals::NoiseLevel& level, const NoiseColour& colour, std::string_view source) {
  if (level.given) return;
  level.sigma = std::max(colour.sigma, 1e-12);
  level.from_the_run = false;
  level.freedom = colour.freedom;
  level.source = fmt::format("{}, {:.0f} samples", source, colour.freedom);
}

// Whether the still runs tell the noise of a channel.
bool take_of_still_runs(PreparedRun& prepared, std::size_t c, const Sources& from) {
  const data::Channel& channel = prepared.run->channels[c];
  signals::NoiseLevel& level = prepared.noise[c];
  std::vector<Stretch> stretches;
  for (const data::Run& run : from.still)
    if (auto found = stretch_of(run, channel.kind, channel.joint, {.last = run.samples()}, fewest_still_samples))
      stretches.push_back(std::move(*found));
  auto colour = colour_of_all(stretches, fewest_still_samples);
  if (!colour || !(colour->sigma > 0.0)) return false;
  (void)without_swings(*colour, stretches, from, *prepared.run);
  take_level(level, *colour, "the still run");
  level.colour = text_of(*colour, "the still run");
  level.colour_unknown = false;
  take_over(prepared, c, *colour);
  return true;
}

// Whether the parts at rest do.
bool take_of_parts_at_rest(PreparedRun& prepared, std::size_t c, const Sources& from) {
  const data::Channel& channel = prepared.run->channels[c];
  signals::NoiseLevel& level = prepared.noise[c];
  std::vector<Stretch> stretches;
  for (const data::Run& run : from.runs)
    if (auto found = stretch_of(run, channel.kind, channel.joint, samples_at_rest(run), shortest_part))
      stretches.push_back(std::move(*found));
  auto colour = colour_of_all(stretches, fewest_samples_at_rest);
  if (!colour || !(colour->sigma > 0.0)) return false;
  if (const auto swing = without_swings(*colour, stretches, from, *prepared.run)) {
    level.colour = fmt::format(
        "taken as white: what comes before the input changes swings at {:.3g} Hz, as the model does, and is not at "
        "rest",
        *swing);
    return false;
  }
  // A compressed film holds a picture in which nothing moves, with its errors: that is not the noise of a motion.
  if (level.given && colour->sigma < 0.5 * level.sigma) {
    level.colour = fmt::format("taken as white: the parts at rest scatter by {:.2g} of it, and do not show its colour",
                               colour->sigma / level.sigma);
    return false;
  }
  level.colour = text_of(*colour, "the parts at rest");
  level.colour_unknown = false;
  if (colour->is_white && colour->lines.empty()) return true;
  take_level(level, *colour, "the parts at rest");
  take_over(prepared, c, *colour);
  return true;
}

void take_recorded_noise(PreparedRun& prepared, const Sources& from) {
  prepared.whiteners.assign(prepared.noise.size(), nullptr);
  prepared.lines.clear();
  prepared.line_sizes.clear();
  for (std::size_t c = 0; c < prepared.noise.size(); ++c) {
    signals::NoiseLevel& level = prepared.noise[c];
    // What another model has told of rest is told anew.
    if (!level.given && !level.from_the_run) level = signals::noise_of(*prepared.run, prepared.run->channels[c]);
    level.colour = "taken as white: there is no still run, and the parts at rest are too short to show its colour";
    level.colour_unknown = true;
    if (!take_of_still_runs(prepared, c, from) && !take_of_parts_at_rest(prepared, c, from))
      take_over_hum(prepared, c, from);
  }
}

void give(PreparedRun& prepared, const Sources& from) {
  if (!prepared.is_motion()) return;
  take_recorded_noise(prepared, from);
  const std::vector<double>& sigma = prepared.run->input_uncertainty.sigma;
  if (sigma.empty()) return;
  for (signals::NoiseLevel& level : prepared.noise)
    level.colour += fmt::format("; white beside the errors of the input, input_sigma {:.6g}", fmt::join(sigma, ", "));
}

}  // namespace

void give_recorded_noise(PreparedRun& prepared, std::span<const data::Run> still, std::span<const data::Run> runs,
                         const actuator::Model& model) {
  give(prepared, {.still = still, .runs = runs, .model = model});
}

bool give_recorded_noise(std::span<PreparedRun> prepared, std::span<const data::Run> still,
                         std::span<const data::Run> runs, const actuator::Model& model,
                         std::span<const Eigen::VectorXd> shown) {
  const std::vector<PreparedRun> before(prepared.begin(), prepared.end());
  std::vector<FittedMotion> motions;
  for (std::size_t r = 0; r < before.size(); ++r)
    if (before[r].is_motion()) motions.push_back({.prepared = &before[r], .shown = shown[r]});
  bool any = false;
  for (std::size_t r = 0; r < before.size(); ++r) {
    give(prepared[r], {.still = still, .runs = runs, .model = model, .motions = motions});
    any = any || prepared[r].lines != before[r].lines ||
          !std::ranges::equal(prepared[r].noise, before[r].noise, {}, &signals::NoiseLevel::colour,
                              &signals::NoiseLevel::colour);
  }
  return any;
}

}  // namespace coilwright::measurement::replay
