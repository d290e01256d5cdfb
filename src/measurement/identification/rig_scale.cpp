#include "measurement/identification/rig_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coilwright::measurement::identification {
namespace {

using actuator::RigScale;
using mechanics::JointVector;

// Rates are differences over so many samples: enough to average the noise, few compared with one oscillation.
constexpr std::size_t slope_samples = 20;

// Sums over all motions, from which root mean squares follow.
struct Sums {
  double torque{}, angle{}, angle_square{}, rate{}, current{};
  double samples{}, angles{}, rates{};
  double upper = -std::numeric_limits<double>::infinity();
  double lower = std::numeric_limits<double>::infinity();
};

void add_inputs(const replay::Window& window, const actuator::Model& nominal, Sums& sums) {
  for (std::size_t i = 0; i < window.input.times.size(); ++i) {
    const actuator::CoilCurrents& currents = window.input.currents[i];
    JointVector torque = nominal.magnetic_torques(JointVector::Zero(nominal.joints()), currents);
    if (!window.input.joint_torques.empty()) torque += window.input.joint_torques[i];
    sums.torque += torque.squaredNorm();
    if (currents.size() > 0) sums.current += currents.squaredNorm() / static_cast<double>(currents.size());
    sums.samples += 1.0;
  }
}

void add_angles(const data::Run& run, const data::Channel& channel, int joints, Sums& sums) {
  if (channel.kind != data::ChannelKind::bending_angle && channel.kind != data::ChannelKind::joint_angle) return;
  const double share = channel.kind == data::ChannelKind::bending_angle ? 1.0 / joints : 1.0;
  for (std::size_t i = 0; i < channel.values.size(); ++i) {
    const double angle = share * channel.values[i];
    sums.angle += angle;
    sums.angle_square += angle * angle;
    sums.upper = std::max(sums.upper, angle);
    sums.lower = std::min(sums.lower, angle);
    sums.angles += 1.0;
    if (i < slope_samples) continue;
    const double rate =
        share * (channel.values[i] - channel.values[i - slope_samples]) / (run.times[i] - run.times[i - slope_samples]);
    sums.rate += rate * rate;
    sums.rates += 1.0;
  }
}

double median_interval(const std::vector<double>& times) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

double root_mean(double sum, double count, double fallback) {
  const double mean = count > 0.0 ? sum / count : 0.0;
  return mean > 0.0 ? std::sqrt(mean) : fallback;
}

}  // namespace

RigScale rig_scale(std::span<const replay::PreparedRun> runs, const actuator::Model& nominal) {
  Sums sums;
  RigScale scale{.interval = std::numeric_limits<double>::infinity()};
  for (const replay::PreparedRun& prepared : runs) {
    if (!prepared.is_motion()) continue;
    const data::Run& run = *prepared.run;
    for (const replay::Window& window : prepared.windows) add_inputs(window, nominal, sums);
    for (const data::Channel& channel : run.channels) add_angles(run, channel, nominal.joints(), sums);
    scale.interval = std::min(scale.interval, median_interval(run.times));
    scale.duration = std::max(scale.duration, run.times.back() - run.times.front());
  }
  const double mean = sums.angles > 0.0 ? sums.angle / sums.angles : 0.0;
  scale.mean_angle = mean;
  scale.angle = root_mean(sums.angle_square - sums.angles * mean * mean, sums.angles, 0.1);
  scale.rate = root_mean(sums.rate, sums.rates, 1.0);
  scale.current = nominal.coils() > 0 ? root_mean(sums.current, sums.samples, 1.0) : 0.0;
  double stiffness = 0.0;
  for (const actuator::Hinge& hinge : nominal.hinges()) stiffness = std::max(stiffness, hinge.stiffness);
  const double static_torque = stiffness > 0.0 ? stiffness * scale.angle : 1.0;
  scale.torque = root_mean(sums.torque, sums.samples, static_torque);
  scale.upper_angle = sums.angles > 0.0 ? sums.upper : scale.angle;
  scale.lower_angle = sums.angles > 0.0 ? sums.lower : -scale.angle;
  if (!std::isfinite(scale.interval)) scale.interval = 1e-3;
  if (scale.duration <= 0.0) scale.duration = 1.0;
  return scale;
}

}  // namespace coilwright::measurement::identification
