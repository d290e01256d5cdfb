#include "coilwright/measurement/localise/residual_torque.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "measurement/localise/binned_dependence.hpp"
#include "measurement/localise/inverse_dynamics.hpp"
#include "measurement/localise/spectral_line.hpp"

namespace coilwright::measurement::localise {
namespace {

void check(std::span<const MeasuredMotion> motions, const actuator::Model& model) {
  const auto joints = static_cast<std::size_t>(model.joints());
  for (const MeasuredMotion& motion : motions) {
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

double mean_square(std::span<const double> values) {
  if (values.empty()) return 0.0;
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0) / static_cast<double>(values.size());
}

// One measured series of all motions, end to end.
struct Pooled {
  std::vector<double> torque, noise, angle, rate, rate_noise, acceleration;
  std::vector<double> time;               // s since the run's first sample
  std::vector<double> run;                // number of the motion, from 1
  std::vector<const MeasuredMotion*> of;  // motion of each sample
  std::vector<std::size_t> sample;        // and its index there
};

Pooled pooled(std::span<const MeasuredMotion> motions, const std::vector<TorqueSeries>& all, std::size_t series) {
  Pooled result;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (std::size_t m = 0; m < motions.size(); ++m) {
    append(result.torque, all[m].torque[series]);
    append(result.noise, all[m].noise[series]);
    append(result.angle, all[m].angle[series]);
    append(result.rate, all[m].rate[series]);
    append(result.rate_noise, all[m].rate_noise[series]);
    append(result.acceleration, all[m].acceleration[series]);
    for (const std::size_t i : all[m].samples) {
      result.time.push_back(motions[m].input.times[i] - motions[m].input.times.front());
      result.run.push_back(static_cast<double>(m + 1));
      result.of.push_back(&motions[m]);
      result.sample.push_back(i);
    }
  }
  return result;
}

// Blocks of samples that outlast the smoother's reach, so that even and odd ones do not share their noise.
Blocks blocks_of(const Pooled& samples, double reach) {
  const auto size = static_cast<std::size_t>(std::ceil(8.0 * reach)) + 1;
  Blocks blocks;
  std::size_t block = 0;
  std::size_t filled = 0;
  for (std::size_t i = 0; i < samples.sample.size(); ++i) {
    if (i > 0 && samples.of[i] != samples.of[i - 1]) {
      // Every second run starts with an odd block: the same time of a run is then on both sides.
      block = (block / 2 + 1) * 2 + static_cast<std::size_t>(samples.run[i] - 1.0) % 2;
      filled = 0;
    } else if (filled == size) {
      ++block;
      filled = 0;
    }
    blocks.of.push_back(block);
    ++filled;
  }
  return blocks;
}

std::vector<double> per_sample(const Pooled& samples,
                               const std::function<double(const MeasuredMotion&, std::size_t)>& value) {
  std::vector<double> values;
  for (std::size_t i = 0; i < samples.sample.size(); ++i) values.push_back(value(*samples.of[i], samples.sample[i]));
  return values;
}

// -1, 0, 1; 0 where the rate is in its noise, or next to it.
std::vector<double> signs(const Pooled& samples) {
  const double least =
      std::max(3.0 * std::sqrt(mean_square(samples.rate_noise)), 0.02 * std::sqrt(mean_square(samples.rate)));
  std::vector<double> result;
  for (const double rate : samples.rate) result.push_back(rate > least ? 1.0 : rate < -least ? -1.0 : 0.0);
  return result;
}

// Sum over the coils of i^2 through a lag of `constant` seconds, from zero at the start of the run.
std::vector<double> heat(const MeasuredMotion& motion, double constant) {
  const std::vector<double>& times = motion.input.times;
  std::vector<double> lagged{0.0};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double power = motion.input.currents[i - 1].squaredNorm();
    lagged.push_back(power + (lagged.back() - power) * std::exp(-(times[i] - times[i - 1]) / constant));
  }
  return lagged;
}

// A sine of that frequency, its phase and amplitude free in each run, found on even blocks and tried on odd ones.
Dependence line_dependence(double frequency, const Pooled& samples, const Blocks& blocks, std::size_t motions) {
  Dependence result{.variable = "frequency"};
  using Normal = Eigen::Matrix3d;
  struct Fit {
    Normal products = Normal::Zero();
    Eigen::Vector3d moments = Eigen::Vector3d::Zero();
    [[nodiscard]] Eigen::Vector3d coefficients() const {
      return products.completeOrthogonalDecomposition().solve(moments);
    }
  };
  const auto wave = [&](std::size_t i) {
    const double phase = 2.0 * std::numbers::pi * frequency * samples.time[i];
    return Eigen::Vector3d(1.0, std::cos(phase), std::sin(phase));
  };
  std::vector<Fit> fits(2 * motions);
  const auto fit_of = [&](std::size_t i, std::size_t parity) {
    return 2 * (static_cast<std::size_t>(samples.run[i]) - 1) + parity;
  };
  double mean = 0.0;
  for (std::size_t i = 0; i < samples.torque.size(); ++i) {
    Fit& fit = fits[fit_of(i, blocks.of[i] % 2)];
    fit.products += wave(i) * wave(i).transpose();
    fit.moments += wave(i) * samples.torque[i];
    mean += samples.torque[i] / static_cast<double>(samples.torque.size());
  }
  std::vector<Eigen::Vector3d> found;
  double amplitude = 0.0;
  for (const Fit& fit : fits) {
    found.push_back(fit.coefficients());
    amplitude += fit.products(0, 0) * found.back().tail<2>().norm() / static_cast<double>(samples.torque.size());
  }
  double left = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < samples.torque.size(); ++i) {
    const double expected = found[fit_of(i, 1 - blocks.of[i] % 2)].dot(wave(i));
    left += (samples.torque[i] - expected) * (samples.torque[i] - expected);
    all += (samples.torque[i] - mean) * (samples.torque[i] - mean);
  }
  if (all > 0.0) result.explained = std::max(1.0 - left / all, 0.0);
  result.at = {frequency};
  result.residual = {amplitude};
  return result;
}

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

void add_currents(std::vector<Dependence>& found, std::span<const MeasuredMotion> motions, const Pooled& samples,
                  const Blocks& blocks, int coils) {
  bool alike = true;
  for (const MeasuredMotion& motion : motions)
    for (const actuator::CoilCurrents& row : motion.input.currents) alike = alike && (row.array() == row[0]).all();
  for (int coil = 0; coil < (alike ? 1 : coils); ++coil)
    found.push_back(binned_dependence(
        alike ? "current" : fmt::format("current of coil {}", coil + 1),
        per_sample(samples, [&](const MeasuredMotion& m, std::size_t i) { return m.input.currents[i][coil]; }),
        samples.torque, blocks));
  double longest = 0.0;
  for (const MeasuredMotion& motion : motions)
    longest = std::max(longest, motion.input.times.back() - motion.input.times.front());
  for (const double constant : {0.1, 1.0, 10.0, 100.0}) {
    if (constant > 2.0 * longest) continue;
    std::vector<double> history;
    const MeasuredMotion* of = nullptr;
    std::vector<double> lagged;
    for (std::size_t i = 0; i < samples.sample.size(); ++i) {
      if (samples.of[i] != of) {
        of = samples.of[i];
        lagged = heat(*of, constant);
      }
      history.push_back(lagged[samples.sample[i]]);
    }
    found.push_back(
        binned_dependence(fmt::format("current history (i^2 over {:g} s)", constant), history, samples.torque, blocks));
  }
}

std::vector<Dependence> dependences_of(std::span<const MeasuredMotion> motions, const Pooled& samples,
                                       const Blocks& blocks, std::size_t series, const actuator::Model& model,
                                       std::optional<double> line) {
  std::vector<Dependence> found;
  const auto meet = [&](const char* name, std::span<const double> variable) {
    found.push_back(binned_dependence(name, variable, samples.torque, blocks));
  };
  meet("angle", samples.angle);
  meet("rate", samples.rate);
  meet("sign of rate", signs(samples));
  meet("acceleration", samples.acceleration);
  meet("time", samples.time);
  meet("run", samples.run);
  if (model.coils() > 0) add_currents(found, motions, samples, blocks, model.coils());
  const bool driven = std::all_of(motions.begin(), motions.end(),
                                  [](const MeasuredMotion& motion) { return !motion.input.joint_torques.empty(); });
  if (driven)
    meet("applied torque", per_sample(samples, [&](const MeasuredMotion& m, std::size_t i) {
           const mechanics::JointVector& torque = m.input.joint_torques[i];
           return m.angles.size() == 1 ? torque.sum() : torque[static_cast<Eigen::Index>(series)];
         }));
  if (line) found.push_back(line_dependence(*line, samples, blocks, motions.size()));
  return found;
}

}  // namespace

ResidualTorque residual_torque(std::span<const MeasuredMotion> motions, const actuator::Model& model) {
  check(motions, model);
  ResidualTorque result;
  if (motions.empty()) return result;
  std::vector<TorqueSeries> all;
  double reach = 0.0;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    // Any seeds will do, if they are always the same and no two series share one.
    all.push_back(torque_series(motions[m], model, 1000 * (m + 1)));
    reach = std::max(reach, all.back().reach);
  }

  const std::size_t count = motions.front().angles.size();
  double strongest = 0.0;
  for (std::size_t series = 0; series < count; ++series) {
    const Pooled samples = pooled(motions, all, series);
    if (samples.torque.empty()) return result;
    result.rms += mean_square(samples.torque);
    result.smallest_visible += mean_square(samples.noise);
    const Blocks blocks = blocks_of(samples, reach);
    const std::optional<double> line = strongest_line(even_series(motions, all, series));
    for (Dependence& found : dependences_of(motions, samples, blocks, series, model, line)) {
      constexpr double visible = 0.02;
      if (found.explained <= visible) continue;
      if (found.variable == "frequency" && mean_square(samples.torque) * found.explained > strongest) {
        strongest = mean_square(samples.torque) * found.explained;
        result.frequency = line;
      }
      if (count > 1) found.variable += fmt::format(" of joint {}", series + 1);
      result.dependences.push_back(std::move(found));
    }
  }
  result.rms = std::sqrt(result.rms);
  result.smallest_visible = std::sqrt(result.smallest_visible);
  const auto merit = [](const Dependence& found) {
    return found.explained - 0.0025 * static_cast<double>(found.at.size());
  };
  std::stable_sort(result.dependences.begin(), result.dependences.end(),
                   [&](const Dependence& a, const Dependence& b) { return merit(a) > merit(b); });
  return result;
}

}  // namespace coilwright::measurement::localise
