#include "measurement/identification/rig_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "measurement/data/median_interval.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::RigScale;
using mechanics::JointVector;

// Rates are differences over so many samples, enough to average the noise; but over no more than this share of the
// period in which a joint swings by itself, within which the motion is nearly straight.
constexpr double most_slope_samples = 20.0;
constexpr double share_of_period = 0.2;

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

void add_angles(const replay::PreparedRun& prepared, std::size_t place, const actuator::Model& nominal, Sums& sums) {
  const data::Run& run = *prepared.run;
  const data::Channel& channel = run.channels[place];
  if (channel.kind != data::ChannelKind::bending_angle && channel.kind != data::ChannelKind::joint_angle) return;
  const double share = channel.kind == data::ChannelKind::bending_angle ? 1.0 / nominal.joints() : 1.0;
  const double straight = share_of_period * shortest_period(nominal) / data::median_interval(run);
  const auto apart = static_cast<std::size_t>(std::clamp(std::round(straight), 1.0, most_slope_samples));
  for (std::size_t i = 0; i < channel.values.size(); ++i) {
    const double angle = share * channel.values[i];
    sums.angle += angle;
    sums.angle_square += angle * angle;
    sums.upper = std::max(sums.upper, angle);
    sums.lower = std::min(sums.lower, angle);
    sums.angles += 1.0;
    if (i < apart || prepared.is_set_aside(place, i) || prepared.is_set_aside(place, i - apart)) continue;
    const double rate = share * (channel.values[i] - channel.values[i - apart]) / (run.times[i] - run.times[i - apart]);
    sums.rate += rate * rate;
    sums.rates += 1.0;
  }
}

double root_mean(double sum, double count, double fallback) {
  const double mean = count > 0.0 ? sum / count : 0.0;
  return mean > 0.0 ? std::sqrt(mean) : fallback;
}

}  // namespace

double shortest_period(const actuator::Model& nominal) {
  const JointVector mobility = nominal.chain().joint_mobility();
  double largest = 0.0;
  for (int j = 0; j < nominal.joints(); ++j) largest = std::max(largest, nominal.hinges()[j].stiffness * mobility[j]);
  return 2.0 * std::numbers::pi / std::sqrt(largest);
}

RigScale rig_scale(std::span<const replay::PreparedRun> runs, const actuator::Model& nominal) {
  Sums sums;
  RigScale scale{.interval = std::numeric_limits<double>::infinity()};
  for (const replay::PreparedRun& prepared : runs) {
    if (!prepared.is_motion()) continue;
    const data::Run& run = *prepared.run;
    for (const replay::Window& window : prepared.windows) add_inputs(window, nominal, sums);
    for (std::size_t place = 0; place < run.channels.size(); ++place) add_angles(prepared, place, nominal, sums);
    scale.interval = std::min(scale.interval, data::median_interval(run));
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
