#include "measurement/fit/outliers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "measurement/replay/prediction.hpp"
#include "measurement/signals/pooled_levels.hpp"
#include "measurement/signals/spikes.hpp"

namespace coilwright::measurement::fit {
namespace {

// What a fit leaves of a channel, one value per sample of the run; nothing where windows leave samples out.
std::optional<std::vector<double>> left_of(const replay::PreparedRun& prepared, std::size_t channel,
                                           const Eigen::VectorXd& predictions) {
  const std::vector<double>& measured = prepared.run->channels[channel].values;
  std::vector<double> out;
  Eigen::Index at = 0;
  for (const replay::SampleRange& range : prepared.sample_ranges()) {
    const auto n = static_cast<Eigen::Index>(range.samples());
    for (Eigen::Index i = 0; i < n; ++i)
      out.push_back(measured[range.first + static_cast<std::size_t>(i)] -
                    predictions[at + static_cast<Eigen::Index>(channel) * n + i]);
    at += n * static_cast<Eigen::Index>(prepared.run->channels.size());
  }
  if (out.size() != prepared.run->samples()) return std::nullopt;
  return out;
}

signals::NoiseLevel level_without_outliers(const replay::PreparedRun& prepared, std::size_t channel,
                                           const std::vector<double>& values) {
  const data::Run& run = *prepared.run;
  const std::vector<char>& aside = prepared.set_aside[channel];
  data::Run cleaned{.name = run.name, .kind = run.kind};
  data::Channel kept{.name = run.channels[channel].name, .kind = run.channels[channel].kind};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!aside.empty() && aside[i] != 0) continue;
    cleaned.times.push_back(run.times[i]);
    kept.values.push_back(values[i]);
  }
  cleaned.channels = {kept};
  return signals::noise_of(cleaned, kept);
}

// A rounded record may have more than half of its differences at zero; a step to the next value is no spike there.
double least_scale(const signals::NoiseLevel& level) {
  return std::max(0.3 * level.sigma, level.resolution / 3.0);
}

// The noise of a channel whose own record tells it, without the samples that are set aside. Where pictures are few, the
// motion between them counts as noise: then what the model leaves, which moves less, tells it better, by the same
// polynomials. Both err upwards only, so the smaller one is taken where they differ by more than chance, as long as
// it is not below what rounding alone leaves.
void take_noise_anew(replay::PreparedRun& prepared, std::size_t channel, const Eigen::VectorXd& predictions) {
  signals::NoiseLevel& level = prepared.noise[channel];
  if (!level.from_the_run) return;
  const std::vector<double>& measured = prepared.run->channels[channel].values;
  std::string colour = std::move(level.colour);
  const bool colour_unknown = level.colour_unknown;
  // Its own: what was drawn to other runs is drawn anew from there.
  level = level_without_outliers(prepared, channel, measured);
  if (const auto left = left_of(prepared, channel, predictions)) {
    signals::NoiseLevel of_left = level_without_outliers(prepared, channel, *left);
    // What a smooth prediction leaves of a rounded record has values in between.
    of_left.resolution = level.resolution;
    of_left.sigma = std::max(of_left.sigma, level.of_rounding());
    constexpr double beyond_chance = 3.0;
    const double chance = 1.0 / std::sqrt(2.0 * of_left.freedom) + 1.0 / std::sqrt(2.0 * level.freedom);
    if (of_left.sigma < level.sigma * (1.0 - std::min(beyond_chance * chance, 0.25))) {
      level = of_left;
      level.source = "of what the recalibrated model leaves, " + level.source;
    }
  }
  level.colour = std::move(colour);
  level.colour_unknown = colour_unknown;
}

// The levels that runs tell of themselves, of each instrument together.
void pool_levels(std::span<replay::PreparedRun> runs) {
  std::map<std::string, std::vector<signals::NoiseLevel*>> by_channel;
  for (replay::PreparedRun& prepared : runs) {
    if (!prepared.is_motion()) continue;
    for (signals::NoiseLevel& level : prepared.noise)
      if (level.from_the_run) by_channel[level.channel].push_back(&level);
  }
  for (const auto& [channel, levels] : by_channel) signals::pool_levels(levels);
}

// True if the sample was not aside before.
bool set_aside(replay::PreparedRun& prepared, std::size_t channel, std::size_t sample) {
  std::vector<char>& aside = prepared.set_aside[channel];
  if (aside.empty()) aside.assign(prepared.run->samples(), 0);
  return std::exchange(aside[sample], char{1}) == 0;
}

}  // namespace

bool set_outliers_aside(std::span<replay::PreparedRun> runs, const Fit& fitted) {
  bool any = false;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    replay::PreparedRun& prepared = runs[r];
    if (!prepared.is_motion()) continue;
    const data::Run& run = *prepared.run;
    const std::size_t channels = run.channels.size();
    prepared.whiteners.resize(channels);
    prepared.set_aside.resize(channels);
    std::vector<char> changed(channels, 0);
    Eigen::Index at = 0;
    for (const replay::SampleRange range : prepared.sample_ranges()) {
      const Eigen::VectorXd measured = replay::measured_values(run, range);
      const auto n = static_cast<Eigen::Index>(range.samples());
      for (std::size_t c = 0; c < channels; ++c, at += n) {
        const Eigen::Index first = static_cast<Eigen::Index>(c) * n;
        const Eigen::VectorXd apart = measured.segment(first, n) - fitted.runs[r].predictions.segment(at, n);
        const std::vector<char> found =
            signals::spikes({apart.data(), range.samples()}, least_scale(prepared.noise[c]));
        for (std::size_t i = 0; i < found.size(); ++i) {
          if (found[i] != 0 && set_aside(prepared, c, range.first + i)) changed[c] = 1;
        }
      }
    }
    for (std::size_t c = 0; c < channels; ++c) {
      if (changed[c] != 0) any = true;
      take_noise_anew(prepared, c, fitted.runs[r].predictions);
    }
  }
  pool_levels(runs);
  return any;
}

bool take_back(std::span<replay::PreparedRun> runs, const Fit& fitted) {
  constexpr double most_deviations = 3.0;
  bool any = false;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    replay::PreparedRun& prepared = runs[r];
    Eigen::Index at = 0;
    for (const replay::SampleRange& range : prepared.sample_ranges()) {
      for (std::size_t c = 0; c < prepared.run->channels.size(); ++c) {
        for (std::size_t i = range.first; i < range.last; ++i, ++at) {
          if (!prepared.is_set_aside(c, i)) continue;
          const double left = prepared.run->channels[c].values[i] - fitted.runs[r].predictions[at];
          if (std::abs(left) > most_deviations * prepared.noise[c].sigma) continue;
          prepared.set_aside[c][i] = 0;
          any = true;
        }
      }
    }
  }
  return any;
}

std::optional<std::vector<replay::PreparedRun>> with_suspects_aside(std::span<const replay::PreparedRun> runs,
                                                                    const Fit& fitted, double most) {
  std::vector<replay::PreparedRun> out(runs.begin(), runs.end());
  bool any = false;
  for (std::size_t r = 0; r < out.size(); ++r) {
    replay::PreparedRun& prepared = out[r];
    if (!prepared.is_motion()) continue;
    const data::Run& run = *prepared.run;
    prepared.whiteners.resize(run.channels.size());
    prepared.set_aside.resize(run.channels.size());
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const auto left = left_of(prepared, c, fitted.runs[r].predictions);
      if (!left) continue;
      const std::vector<char> suspects = signals::far_values(*left, prepared.noise[c].sigma, most);
      for (std::size_t i = 0; i < suspects.size(); ++i)
        if (suspects[i] != 0 && set_aside(prepared, c, i)) any = true;
    }
  }
  return any ? std::optional(std::move(out)) : std::nullopt;
}

bool set_outliers_aside_if_much(std::span<replay::PreparedRun> runs, const Fit& fitted) {
  constexpr double much = 0.2;
  std::vector<replay::PreparedRun> anew(runs.begin(), runs.end());
  if (!set_outliers_aside(anew, fitted)) return false;
  double squares = 0.0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    Eigen::Index at = 0;
    for (const replay::SampleRange& range : runs[r].sample_ranges()) {
      for (std::size_t c = 0; c < runs[r].run->channels.size(); ++c) {
        for (std::size_t i = range.first; i < range.last; ++i, ++at)
          if (anew[r].is_set_aside(c, i) && !runs[r].is_set_aside(c, i))
            squares += std::pow(fitted.runs[r].residuals[at], 2);
      }
    }
  }
  if (squares < much * (fitted.chi_square - static_cast<double>(fitted.samples()))) return false;
  std::ranges::move(anew, runs.begin());
  return true;
}

}  // namespace coilwright::measurement::fit
