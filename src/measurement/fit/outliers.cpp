#include "measurement/fit/outliers.hpp"

#include <algorithm>
#include <limits>

#include "measurement/noise/spikes.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::fit {
namespace {

// The noise of the record without the samples that are set aside: their values straight between those beside them.
void take_noise_anew(replay::PreparedRun& prepared, std::size_t channel) {
  noise::NoiseLevel& level = prepared.noise[channel];
  if (!level.from_the_run) return;
  const data::Run& run = *prepared.run;
  data::Run cleaned{.name = run.name, .kind = run.kind, .times = run.times, .channels = {run.channels[channel]}};
  std::vector<double>& values = cleaned.channels.front().values;
  const std::vector<char>& aside = prepared.set_aside[channel];
  std::vector<double> times;
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (aside[i] != 0) continue;
    times.push_back(run.times[i]);
    kept.push_back(values[i]);
  }
  cleaned.times = std::move(times);
  values = std::move(kept);
  std::string colour = std::move(level.colour);
  level = noise::noise_of(cleaned, cleaned.channels.front());
  level.colour = std::move(colour);
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
        // A rounded record may have more than half its differences at zero.
        const std::vector<char> found = noise::spikes({apart.data(), range.samples()}, 0.3 * prepared.noise[c].sigma);
        for (std::size_t i = 0; i < found.size(); ++i) {
          if (found[i] == 0) continue;
          if (prepared.set_aside[c].empty()) prepared.set_aside[c].assign(run.samples(), 0);
          char& aside = prepared.set_aside[c][range.first + i];
          if (aside == 0) changed[c] = 1;
          aside = 1;
        }
      }
    }
    for (std::size_t c = 0; c < channels; ++c) {
      if (changed[c] == 0) continue;
      any = true;
      take_noise_anew(prepared, c);
    }
  }
  return any;
}

}  // namespace coilwright::measurement::fit
