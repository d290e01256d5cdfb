#include "measurement/localise/inverse_dynamics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "measurement/signals/whittaker_smoother.hpp"

namespace coilwright::measurement::localise {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

constexpr std::size_t shortest_window = 16;  // samples

// Angles smoothed window by window, with their derivatives; one value per sample.
struct SmoothedSeries {
  std::vector<double> angle, rate, acceleration;
};

// Measured minus simulated angles, for each measured series.
using Deviation = std::vector<SmoothedSeries>;

// By the method of Box and Muller with the Mersenne twister: the same in every standard library, unlike
// std::normal_distribution.
std::vector<double> white_noise(std::size_t count, double sigma, unsigned long seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<double> values(count);
  for (double& value : values) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    value = sigma * radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  return values;
}

// The share of each joint in the bending that a small torque, equal in all joints, causes at rest; equal shares if the
// pose has no stiffness.
JointVector bending_shares(const actuator::Model& model, const JointVector& angles,
                           const actuator::CoilCurrents& currents) {
  const JointVector ones = JointVector::Ones(model.joints());
  const Eigen::LLT<JointMatrix> stiffness(model.tangent_stiffness(angles, currents));
  if (stiffness.info() == Eigen::Success) {
    const JointVector bent = stiffness.solve(ones);
    if (bent.allFinite() && bent.minCoeff() > 0.0) return bent / bent.sum();
  }
  return ones / static_cast<double>(model.joints());
}

class InverseDynamics {
 public:
  explicit InverseDynamics(const MeasuredMotion& motion)
      : motion_(motion), model_(*motion.model), bending_(motion.angles.size() == 1), slopes_(model_.internal_states()) {
    if (!bending_ || motion.simulated.empty()) return;
    JointVector mean = JointVector::Zero(model_.joints());
    for (const simulation::State& state : motion.simulated) mean += state.angles;
    mean /= static_cast<double>(motion.simulated.size());
    shares_ = bending_shares(model_, mean, model_.all_coils(0.0));
  }

  // Torque, N m, and measured acceleration, rad/s^2, of each measured series.
  struct Result {
    std::vector<double> torque, acceleration;
  };
  [[nodiscard]] Result at(std::size_t sample, const Deviation& deviation) {
    const simulation::State& state = motion_.simulated[sample];
    const JointVector applied = motion_.input.joint_torques.empty() ? JointVector::Zero(model_.joints()).eval()
                                                                    : motion_.input.joint_torques[sample];
    const JointVector angles = state.angles + split(deviation, &SmoothedSeries::angle, sample);
    const JointVector rates = state.rates + split(deviation, &SmoothedSeries::rate, sample);
    const JointVector measured = acceleration(state.angles, state.rates, state, sample, applied) +
                                 split(deviation, &SmoothedSeries::acceleration, sample);
    const JointVector lacking = measured - acceleration(angles, rates, state, sample, applied);
    const JointMatrix mass = model_.chain().mass_matrix(angles);
    if (!bending_) {
      const JointVector torques = mass * lacking;
      return {{torques.data(), torques.data() + torques.size()}, {measured.data(), measured.data() + measured.size()}};
    }
    // The one torque t in all joints with 1^T M^-1 1 t = 1^T lacking.
    const JointVector mobility = mass.llt().solve(JointVector::Ones(model_.joints()));
    return {{lacking.sum() / mobility.sum()}, {measured.sum()}};
  }

 private:
  // What a deviation means for each joint.
  [[nodiscard]] JointVector split(const Deviation& deviation, std::vector<double> SmoothedSeries::*part,
                                  std::size_t sample) const {
    if (bending_) return (deviation.front().*part)[sample] * shares_;
    JointVector values(model_.joints());
    for (int j = 0; j < model_.joints(); ++j) values[j] = (deviation[static_cast<std::size_t>(j)].*part)[sample];
    return values;
  }
  // The internal states of effects are those of the simulated motion.
  [[nodiscard]] JointVector acceleration(const JointVector& angles, const JointVector& rates,
                                         const simulation::State& state, std::size_t sample,
                                         const JointVector& applied) {
    JointVector result(model_.joints());
    model_.derivative(angles, rates, {state.internal.data(), static_cast<std::size_t>(state.internal.size())},
                      motion_.input.currents[sample], applied, result, slopes_);
    return result;
  }

  const MeasuredMotion& motion_;
  const actuator::Model& model_;
  bool bending_;
  JointVector shares_;
  std::vector<double> slopes_;
};

// The value of a measured series in joint angles or rates.
double in_series(const MeasuredMotion& motion, std::size_t series, const JointVector& values) {
  return motion.angles.size() == 1 ? values.sum() : values[static_cast<Eigen::Index>(series)];
}

// First samples of all windows, and one past the last sample.
std::vector<std::size_t> window_bounds(const MeasuredMotion& motion) {
  std::vector<std::size_t> result = motion.starts;
  result.push_back(motion.input.times.size());
  return result;
}

SmoothedSeries smoothed_windows(std::span<const double> times, const std::vector<double>& values,
                                const std::vector<std::size_t>& bounds, double penalty) {
  SmoothedSeries out;
  for (std::size_t w = 0; w + 1 < bounds.size(); ++w) {
    const std::size_t size = bounds[w + 1] - bounds[w];
    const auto segment = times.subspan(bounds[w], size);
    const std::vector<double> smooth = signals::smoothed(segment, std::span(values).subspan(bounds[w], size), penalty);
    const signals::Derivatives slopes = signals::derivatives(segment, smooth);
    out.angle.insert(out.angle.end(), smooth.begin(), smooth.end());
    out.rate.insert(out.rate.end(), slopes.first.begin(), slopes.first.end());
    out.acceleration.insert(out.acceleration.end(), slopes.second.begin(), slopes.second.end());
  }
  return out;
}

}  // namespace

TorqueSeries residual_torque_series(const MeasuredMotion& motion, unsigned long seed) {
  const std::vector<double>& times = motion.input.times;
  const std::vector<std::size_t> bounds = window_bounds(motion);
  const std::size_t count = motion.angles.size();
  TorqueSeries result;
  result.torque.resize(count);
  result.noise.resize(count);
  result.angle.resize(count);
  result.rate.resize(count);
  result.acceleration.resize(count);
  result.rate_noise.resize(count);

  Deviation measured;
  Deviation noise;
  for (std::size_t s = 0; s < count; ++s) {
    std::vector<double> values(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      values[i] = motion.angles[s][i] - in_series(motion, s, motion.simulated[i].angles);
    std::vector<signals::SampledSegment> segments;
    for (std::size_t w = 0; w + 1 < bounds.size(); ++w)
      if (const std::size_t size = bounds[w + 1] - bounds[w]; size >= shortest_window)
        segments.push_back({std::span(times).subspan(bounds[w], size), std::span(values).subspan(bounds[w], size)});
    if (segments.empty()) return result;
    const double penalty = signals::best_penalty(segments, motion.sigma[s]);
    result.smoothing_length = std::max(result.smoothing_length, signals::smoothing_length(penalty));
    measured.push_back(smoothed_windows(times, values, bounds, penalty));
    noise.push_back(smoothed_windows(times, white_noise(times.size(), motion.sigma[s], seed + s), bounds, penalty));
  }
  Deviation both = measured;
  for (std::size_t s = 0; s < count; ++s)
    for (std::size_t i = 0; i < times.size(); ++i) {
      both[s].angle[i] += noise[s].angle[i];
      both[s].rate[i] += noise[s].rate[i];
      both[s].acceleration[i] += noise[s].acceleration[i];
    }

  InverseDynamics dynamics(motion);
  for (std::size_t w = 0; w + 1 < bounds.size(); ++w) {
    const std::size_t size = bounds[w + 1] - bounds[w];
    if (size < shortest_window) continue;
    // Near an end the smoother has data on one side only. At most a quarter of a short window is left out there.
    const std::size_t margin = std::min(static_cast<std::size_t>(std::ceil(2.0 * result.smoothing_length)), size / 4);
    for (std::size_t i = bounds[w] + margin; i < bounds[w + 1] - margin; ++i) {
      const InverseDynamics::Result found = dynamics.at(i, measured);
      const InverseDynamics::Result disturbed = dynamics.at(i, both);
      result.samples.push_back(i);
      for (std::size_t s = 0; s < count; ++s) {
        result.torque[s].push_back(found.torque[s]);
        result.noise[s].push_back(disturbed.torque[s] - found.torque[s]);
        result.acceleration[s].push_back(found.acceleration[s]);
        result.angle[s].push_back(in_series(motion, s, motion.simulated[i].angles) + measured[s].angle[i]);
        result.rate[s].push_back(in_series(motion, s, motion.simulated[i].rates) + measured[s].rate[i]);
        result.rate_noise[s].push_back(noise[s].rate[i]);
      }
    }
  }
  return result;
}

}  // namespace coilwright::measurement::localise
