#include "coilwright/measurement/localise/residual_torque.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include "measurement/localise/dependences.hpp"
#include "measurement/localise/inverse_dynamics.hpp"
#include "measurement/localise/pooled_series.hpp"
#include "measurement/localise/spectral_line.hpp"

namespace coilwright::measurement::localise {
namespace {

// Throws std::invalid_argument naming run and rule if sizes do not match, or a motion has no model.
void validate_motions(std::span<const MeasuredMotion> motions) {
  for (const MeasuredMotion& motion : motions) {
    if (motion.model == nullptr) throw std::invalid_argument(fmt::format("{}: needs a model", motion.run));
    const actuator::Model& model = *motion.model;
    const auto joints = static_cast<std::size_t>(model.joints());
    const auto require = [&](bool met, const char* rule, std::size_t got) {
      if (!met) throw std::invalid_argument(fmt::format("{}: {}; got {}", motion.run, rule, got));
    };
    try {
      motion.input.require_fits(model);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", motion.run, error.what()));
    }
    const std::size_t n = motion.input.times.size();
    require(motion.simulated.size() == n, "one simulated state for each sample", motion.simulated.size());
    for (const simulation::State& state : motion.simulated) {
      require(state.angles.size() == model.joints() && state.rates.size() == model.joints(),
              "a simulated state must have one angle and rate for each joint",
              static_cast<std::size_t>(state.angles.size()));
      require(state.internal.size() == model.internal_states(), "a simulated state must have the effects' own states",
              static_cast<std::size_t>(state.internal.size()));
    }
    require(motion.angles.size() == 1 || motion.angles.size() == joints,
            "measured angles must be of every joint, or their sum", motion.angles.size());
    require(motion.angles.size() == motions.front().angles.size(), "all motions must be measured alike",
            motion.angles.size());
    for (const std::vector<double>& series : motion.angles)
      require(series.size() == n, "one measured angle for each sample", series.size());
    require(motion.sigma.size() == motion.angles.size(), "one sigma for each measured series", motion.sigma.size());
    for (const double sigma : motion.sigma)
      if (!(sigma > 0.0)) throw std::invalid_argument(fmt::format("{}: sigma must be > 0; got {}", motion.run, sigma));
    require(!motion.starts.empty() && motion.starts.front() == 0, "the first window must start at sample 0",
            motion.starts.empty() ? 0 : motion.starts.front());
    for (std::size_t w = 1; w < motion.starts.size(); ++w)
      require(motion.starts[w] > motion.starts[w - 1] && motion.starts[w] < n,
              "starts of windows must rise and stay inside the run", motion.starts[w]);
  }
}

// A dependence that explains less of the variance is not reported.
constexpr double least_explained = 0.02;
// Variance that each bin of a dependence must explain to be worth its complexity.
constexpr double explained_per_bin = 0.0025;

std::vector<EvenSeries> even_series(std::span<const MeasuredMotion> motions, const std::vector<TorqueSeries>& all,
                                    std::size_t series) {
  std::vector<EvenSeries> result;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const std::vector<double>& torque = all[m].torque[series];
    if (torque.empty()) continue;
    const std::vector<double>& times = motions[m].input.times;
    const double mean = std::accumulate(torque.begin(), torque.end(), 0.0) / static_cast<double>(torque.size());
    const std::size_t first = all[m].samples.front();
    EvenSeries even{.interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1),
                    .values = std::vector<double>(all[m].samples.back() - first + 1, 0.0)};
    for (std::size_t i = 0; i < torque.size(); ++i) even.values[all[m].samples[i] - first] = torque[i] - mean;
    result.push_back(std::move(even));
  }
  return result;
}

}  // namespace

ResidualTorque residual_torque(std::span<const MeasuredMotion> motions) {
  validate_motions(motions);
  ResidualTorque result;
  if (motions.empty()) return result;
  std::vector<TorqueSeries> all;
  double longest_smoothing = 0.0;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    // Any seeds are suitable that are always the same and that no two series share.
    all.push_back(residual_torque_series(motions[m], 1000 * (m + 1)));
    longest_smoothing = std::max(longest_smoothing, all.back().smoothing_length);
  }

  const std::size_t count = motions.front().angles.size();
  double strongest = 0.0;
  for (std::size_t series = 0; series < count; ++series) {
    const PooledSeries samples = pooled(motions, all, series);
    if (samples.torque.empty()) return result;
    result.rms += mean_square(samples.torque);
    result.noise_floor += mean_square(samples.noise);
    const SampleBlocks blocks = blocks_of(samples, longest_smoothing);
    const std::optional<double> line = strongest_spectral_line(even_series(motions, all, series));
    for (Dependence& found : dependences_of(motions, samples, blocks, series, line)) {
      if (found.explained <= least_explained) continue;
      if (found.variable == "frequency" && mean_square(samples.torque) * found.explained > strongest) {
        strongest = mean_square(samples.torque) * found.explained;
        result.frequency = line;
      }
      if (count > 1) found.variable += fmt::format(" of joint {}", series + 1);
      result.dependences.push_back(std::move(found));
    }
  }
  result.rms = std::sqrt(result.rms);
  result.noise_floor = std::sqrt(result.noise_floor);
  const auto merit = [](const Dependence& found) {
    return found.explained - explained_per_bin * static_cast<double>(found.at.size());
  };
  std::stable_sort(result.dependences.begin(), result.dependences.end(),
                   [&](const Dependence& a, const Dependence& b) { return merit(a) > merit(b); });
  return result;
}

}  // namespace coilwright::measurement::localise
