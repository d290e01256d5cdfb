#include "measurement/localise/inverse_dynamics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "measurement/localise/whittaker_smoother.hpp"

namespace coilwright::measurement::localise {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

constexpr std::size_t shortest = 16;

// Deviation of the measured from the simulated angles, with its derivatives, per measured series.
struct Deviation {
  std::vector<std::vector<double>> angle, rate, acceleration;
};

// Box and Muller on the Mersenne twister: the same in every standard library, unlike std::normal_distribution.
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

// How a small torque, the same in all joints, shares its bending among them at rest; equal shares where the pose has
// no stiffness.
JointVector shares(const actuator::Model& model, const JointVector& angles, const actuator::CoilCurrents& currents) {
  const JointVector ones = JointVector::Ones(model.joints());
  const Eigen::LLT<JointMatrix> stiffness(model.tangent_stiffness(angles, currents));
  if (stiffness.info() == Eigen::Success) {
    const JointVector bent = stiffness.solve(ones);
    if (bent.allFinite() && bent.minCoeff() > 0.0) return bent / bent.sum();
  }
  return ones / static_cast<double>(model.joints());
}

class Equation {
 public:
  Equation(const MeasuredMotion& motion, const actuator::Model& model)
      : motion_(motion), model_(model), bending_(motion.angles.size() == 1), slopes_(model.internal_states()) {
    if (!bending_ || motion.simulated.empty()) return;
    JointVector mean = JointVector::Zero(model.joints());
    for (const simulation::State& state : motion.simulated) mean += state.angles;
    mean /= static_cast<double>(motion.simulated.size());
    shares_ = shares(model, mean, model.all_coils(0.0));
  }

  // Per measured series: torque, N m, and measured acceleration, rad/s^2.
  struct Answer {
    std::vector<double> torque, acceleration;
  };
  [[nodiscard]] Answer at(std::size_t sample, const Deviation& deviation) {
    const simulation::State& state = motion_.simulated[sample];
    const JointVector applied = motion_.input.joint_torques.empty() ? JointVector::Zero(model_.joints()).eval()
                                                                    : motion_.input.joint_torques[sample];
    const JointVector angles = state.angles + split(deviation.angle, sample);
    const JointVector rates = state.rates + split(deviation.rate, sample);
    const JointVector measured =
        acceleration(state.angles, state.rates, state, sample, applied) + split(deviation.acceleration, sample);
    const JointVector lacking = measured - acceleration(angles, rates, state, sample, applied);
    const JointMatrix mass = model_.chain().mass_matrix(angles);
    if (!bending_) {
      const JointVector torques = mass * lacking;
      return {{torques.data(), torques.data() + torques.size()}, {measured.data(), measured.data() + measured.size()}};
    }
    // The one torque t in all joints with 1^T M^-1 1 t = 1^T lacking.
    const JointVector answer = mass.llt().solve(JointVector::Ones(model_.joints()));
    return {{lacking.sum() / answer.sum()}, {measured.sum()}};
  }

 private:
  [[nodiscard]] JointVector split(const std::vector<std::vector<double>>& series, std::size_t sample) const {
    if (bending_) return series.front()[sample] * shares_;
    JointVector values(model_.joints());
    for (int j = 0; j < model_.joints(); ++j) values[j] = series[j][sample];
    return values;
  }
  // The effects' own states are those of the simulated motion.
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

double simulated(const MeasuredMotion& motion, std::size_t series, std::size_t sample, bool rate) {
  const JointVector& values = rate ? motion.simulated[sample].rates : motion.simulated[sample].angles;
  return motion.angles.size() == 1 ? values.sum() : values[static_cast<Eigen::Index>(series)];
}

std::vector<std::size_t> edges(const MeasuredMotion& motion) {
  std::vector<std::size_t> result = motion.starts;
  result.push_back(motion.input.times.size());
  return result;
}

void smooth_into(Deviation& deviation, std::span<const double> times, const std::vector<double>& values,
                 const std::vector<std::size_t>& bounds, double penalty) {
  std::vector<double> angle, rate, acceleration;
  for (std::size_t w = 0; w + 1 < bounds.size(); ++w) {
    const std::size_t size = bounds[w + 1] - bounds[w];
    const auto stretch = times.subspan(bounds[w], size);
    const std::vector<double> smooth = smoothed(stretch, std::span(values).subspan(bounds[w], size), penalty);
    const Derivatives slopes = derivatives(stretch, smooth);
    angle.insert(angle.end(), smooth.begin(), smooth.end());
    rate.insert(rate.end(), slopes.first.begin(), slopes.first.end());
    acceleration.insert(acceleration.end(), slopes.second.begin(), slopes.second.end());
  }
  deviation.angle.push_back(std::move(angle));
  deviation.rate.push_back(std::move(rate));
  deviation.acceleration.push_back(std::move(acceleration));
}

}  // namespace

TorqueSeries torque_series(const MeasuredMotion& motion, const actuator::Model& model, unsigned long seed) {
  const std::vector<double>& times = motion.input.times;
  const std::vector<std::size_t> bounds = edges(motion);
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
    for (std::size_t i = 0; i < times.size(); ++i) values[i] = motion.angles[s][i] - simulated(motion, s, i, false);
    std::vector<Stretch> stretches;
    for (std::size_t w = 0; w + 1 < bounds.size(); ++w)
      if (const std::size_t size = bounds[w + 1] - bounds[w]; size >= shortest)
        stretches.push_back({std::span(times).subspan(bounds[w], size), std::span(values).subspan(bounds[w], size)});
    if (stretches.empty()) return result;
    const double penalty = best_penalty(stretches, motion.sigma[s]);
    result.reach = std::max(result.reach, smoothing_length(penalty));
    smooth_into(measured, times, values, bounds, penalty);
    smooth_into(noise, times, white_noise(times.size(), motion.sigma[s], seed + s), bounds, penalty);
  }
  Deviation both = measured;
  for (std::size_t s = 0; s < count; ++s)
    for (std::size_t i = 0; i < times.size(); ++i) {
      both.angle[s][i] += noise.angle[s][i];
      both.rate[s][i] += noise.rate[s][i];
      both.acceleration[s][i] += noise.acceleration[s][i];
    }

  Equation equation(motion, model);
  for (std::size_t w = 0; w + 1 < bounds.size(); ++w) {
    const std::size_t size = bounds[w + 1] - bounds[w];
    if (size < shortest) continue;
    // Near an end the smoother has data on one side only; a quarter of a short window is the most that is given up.
    const std::size_t margin = std::min(static_cast<std::size_t>(std::ceil(2.0 * result.reach)), size / 4);
    for (std::size_t i = bounds[w] + margin; i < bounds[w + 1] - margin; ++i) {
      const Equation::Answer answer = equation.at(i, measured);
      const Equation::Answer disturbed = equation.at(i, both);
      result.samples.push_back(i);
      for (std::size_t s = 0; s < count; ++s) {
        result.torque[s].push_back(answer.torque[s]);
        result.noise[s].push_back(disturbed.torque[s] - answer.torque[s]);
        result.acceleration[s].push_back(answer.acceleration[s]);
        result.angle[s].push_back(simulated(motion, s, i, false) + measured.angle[s][i]);
        result.rate[s].push_back(simulated(motion, s, i, true) + measured.rate[s][i]);
        result.rate_noise[s].push_back(noise.rate[s][i]);
      }
    }
  }
  return result;
}

}  // namespace coilwright::measurement::localise
