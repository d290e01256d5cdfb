#include "measurement/localise/dependences.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "coilwright/algebra/minimum_norm.hpp"
#include "coilwright/measurement/localise/dependence.hpp"
#include "measurement/localise/binned_dependence.hpp"
#include "measurement/localise/pooled_series.hpp"

namespace coilwright::measurement::localise {
namespace {

// Least squares of mean, cosine and sine.
struct HarmonicFit {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d coefficients() const { return algebra::minimum_norm(products, moments); }
};

// How much of the torque's variance a sine of `frequency` (Hz) explains whose phase and amplitude are free in each
// run: fitted to even blocks and tested on odd ones, and the reverse. Its `residual` is the mean amplitude.
Dependence harmonic_dependence(double frequency, const PooledSeries& samples, const SampleBlocks& blocks,
                               std::size_t motions) {
  Dependence result{.variable = "frequency"};
  const auto wave = [&](std::size_t i) {
    const double phase = 2.0 * std::numbers::pi * frequency * samples.time[i];
    return Eigen::Vector3d(1.0, std::cos(phase), std::sin(phase));
  };
  std::vector<HarmonicFit> fits(2 * motions);
  const auto fit_of = [&](std::size_t i, std::size_t parity) {
    return 2 * (static_cast<std::size_t>(samples.run[i]) - 1) + parity;
  };
  double mean = 0.0;
  for (std::size_t i = 0; i < samples.torque.size(); ++i) {
    HarmonicFit& fit = fits[fit_of(i, blocks.number[i] % 2)];
    fit.products += wave(i) * wave(i).transpose();
    fit.moments += wave(i) * samples.torque[i];
    mean += samples.torque[i] / static_cast<double>(samples.torque.size());
  }
  std::vector<Eigen::Vector3d> coefficients;
  double amplitude = 0.0;
  for (const HarmonicFit& fit : fits) {
    coefficients.push_back(fit.coefficients());
    amplitude += fit.products(0, 0) * coefficients.back().tail<2>().norm() / static_cast<double>(samples.torque.size());
  }
  double left = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < samples.torque.size(); ++i) {
    const double expected = coefficients[fit_of(i, 1 - blocks.number[i] % 2)].dot(wave(i));
    left += (samples.torque[i] - expected) * (samples.torque[i] - expected);
    all += (samples.torque[i] - mean) * (samples.torque[i] - mean);
  }
  if (all > 0.0) result.explained = std::max(1.0 - left / all, 0.0);
  result.at = {frequency};
  result.residual = {amplitude};
  return result;
}

std::vector<double> per_sample(const PooledSeries& samples,
                               const std::function<double(const MeasuredMotion&, std::size_t)>& value) {
  std::vector<double> values;
  for (std::size_t i = 0; i < samples.sample.size(); ++i)
    values.push_back(value(*samples.motion[i], samples.sample[i]));
  return values;
}

// -1, 0 or 1 for each sample; 0 if the rate is within its noise, or nearly.
std::vector<double> signs_of_rate(const PooledSeries& samples) {
  const double least =
      std::max(3.0 * std::sqrt(mean_square(samples.rate_noise)), 0.02 * std::sqrt(mean_square(samples.rate)));
  std::vector<double> result;
  for (const double rate : samples.rate) result.push_back(rate > least ? 1.0 : rate < -least ? -1.0 : 0.0);
  return result;
}

// Sum over the coils of i^2 after a first-order lag of `constant` seconds, from zero at the start of the run.
std::vector<double> lagged_heat(const MeasuredMotion& motion, double constant) {
  const std::vector<double>& times = motion.input.times;
  std::vector<double> lagged{0.0};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double power = motion.input.currents[i - 1].squaredNorm();
    lagged.push_back(power + (lagged.back() - power) * std::exp(-(times[i] - times[i - 1]) / constant));
  }
  return lagged;
}

std::vector<Dependence> current_dependences(std::span<const MeasuredMotion> motions, const PooledSeries& samples,
                                            const SampleBlocks& blocks, int coils) {
  std::vector<Dependence> found;
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
      if (samples.motion[i] != of) {
        of = samples.motion[i];
        lagged = lagged_heat(*of, constant);
      }
      history.push_back(lagged[samples.sample[i]]);
    }
    found.push_back(
        binned_dependence(fmt::format("current history (i^2 over {:g} s)", constant), history, samples.torque, blocks));
  }
  return found;
}

}  // namespace

std::vector<Dependence> dependences_of(std::span<const MeasuredMotion> motions, const PooledSeries& samples,
                                       const SampleBlocks& blocks, std::size_t series, std::optional<double> line) {
  std::vector<Dependence> found;
  const auto add = [&](const char* name, std::span<const double> variable) {
    found.push_back(binned_dependence(name, variable, samples.torque, blocks));
  };
  add("angle", samples.angle);
  add("rate", samples.rate);
  add("sign of rate", signs_of_rate(samples));
  add("acceleration", samples.acceleration);
  add("time", samples.time);
  add("run", samples.run);
  if (const int coils = motions.front().model->coils(); coils > 0) {
    std::vector<Dependence> on_currents = current_dependences(motions, samples, blocks, coils);
    found.insert(found.end(), on_currents.begin(), on_currents.end());
  }
  const bool driven = std::all_of(motions.begin(), motions.end(),
                                  [](const MeasuredMotion& motion) { return !motion.input.joint_torques.empty(); });
  if (driven)
    add("applied torque", per_sample(samples, [&](const MeasuredMotion& m, std::size_t i) {
          const mechanics::JointVector& torque = m.input.joint_torques[i];
          return m.angles.size() == 1 ? torque.sum() : torque[static_cast<Eigen::Index>(series)];
        }));
  if (line) found.push_back(harmonic_dependence(*line, samples, blocks, motions.size()));
  return found;
}

}  // namespace coilwright::measurement::localise
