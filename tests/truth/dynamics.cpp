#include "truth/dynamics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/torque_curves.hpp"

namespace truth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double stop_damping_ratio = 0.3;
constexpr double iron_blur = 0.5;  // share of the range: iron has an extent

Vector2d turned(const Vector2d& v) {
  return {-v.y(), v.x()};
}

// A point of a link (along, across) that makes `angle` with the vertical: the paper's (1), (2).
Vector2d on_link(double along, double across, double sine, double cosine) {
  return {along * sine - across * cosine, -along * cosine - across * sine};
}

}  // namespace

Dynamics::Dynamics(const Finger& finger, const UnmodelledEffects& effects) : finger_(finger), effects_(effects) {
  if (effects_.stop_stiffness <= 0.0) return;
  // 0.3 of the critical damping, with the effective inertia of a joint in the straight finger while the other is free.
  const Eigen::Matrix2d mobility = balance({}, 0.0).inertia.topLeftCorner<2, 2>().inverse();
  for (int j = 0; j < 2; ++j)
    stop_damping_[j] = 2.0 * stop_damping_ratio * std::sqrt(effects_.stop_stiffness / mobility(j, j));
}

double Dynamics::target(double command) const {
  double current = command;
  if (effects_.deadband > 0.0) current = std::copysign(std::max(std::abs(current) - effects_.deadband, 0.0), current);
  current = std::clamp(current, -effects_.saturation, effects_.saturation);
  return current + effects_.current_offset;
}

double Dynamics::current(double t) const {
  if (effects_.current_lag <= 0.0) return input.target;
  return input.target + (input.from - input.target) * std::exp(-(t - input.since) / effects_.current_lag);
}

Vector2d Dynamics::joint_torques(const StateVector& state, double t) const {
  const double cold_current = current(t);
  const double warm_current = cold_current / (1.0 + state[StateIndex::coil_heat]);
  const double strength = effects_.force_gain * (1.0 - state[StateIndex::magnet_heat]) * warm_current;
  Vector2d torques;
  for (int j = 0; j < 2; ++j) {
    const double angle = state[StateIndex::angle + j];
    const double rate = state[StateIndex::rate + j];
    const double per_ampere = effects_.off_axis ? curves::exact(angle) : curves::line_of_centres(angle);
    double stiffness = finger_.stiffness * input.stiffness * (j == 1 ? effects_.second_stiffness_ratio : 1.0);
    if (effects_.mullins > 0.0)
      stiffness *=
          1.0 - effects_.mullins *
                    (1.0 - std::exp(-std::max(input.largest_angle[j], std::abs(angle)) / effects_.mullins_angle));
    double torque = strength * per_ampere - stiffness * (angle - effects_.rest_angle) -
                    stiffness * effects_.hardening * angle * angle * angle - finger_.damping * rate + input.pull;
    torque -= effects_.motional_conductance * per_ampere * per_ampere * rate;
    torque -= effects_.drag * rate * std::abs(rate);
    torque -= effects_.creep_share * stiffness * (angle - state[StateIndex::creep + j]);
    torque -= effects_.hysteresis * state[StateIndex::hysteresis + j];
    if (effects_.attraction != 0.0 && j == 0) {
      const double distance = 1.0 - effects_.attraction_side * angle / effects_.attraction_range;
      const double blur = iron_blur * iron_blur;
      torque += effects_.attraction * std::pow((1.0 + blur) / (distance * distance + blur), 2);
    }
    if (effects_.stop_stiffness > 0.0) {
      const double beyond = effects_.stop_side * (angle - effects_.stop_angle);
      const double deeper = effects_.stop_side * rate;
      if (beyond > 0.0)
        torque -= effects_.stop_side * std::max(effects_.stop_stiffness * beyond + stop_damping_[j] * deeper, 0.0);
    }
    if (effects_.ripple != 0.0) torque += effects_.ripple * std::sin(effects_.ripple_count * angle);
    torques[j] = torque;
  }
  if (effects_.coil_coil) {
    const CoilCoilTorque between = curves::coil_coil(state[StateIndex::angle], state[StateIndex::angle + 1]);
    torques += warm_current * warm_current * Vector2d(between.first, between.second);
  }
  return torques;
}

Dynamics::Balance Dynamics::balance(const StateVector& state, double t) const {
  const double first = state[StateIndex::angle];
  const double second = first + state[StateIndex::angle + 1];
  const double first_rate = state[StateIndex::rate];
  const double second_rate = first_rate + state[StateIndex::rate + 1];
  const double s1 = std::sin(first);
  const double c1 = std::cos(first);
  const double s2 = std::sin(second);
  const double c2 = std::cos(second);
  const Vector2d mass1 = on_link(finger_.half_pitch, finger_.axis_offset, s1, c1);
  const Vector2d joint2 = on_link(2.0 * finger_.half_pitch, 0.0, s1, c1);
  const Vector2d arm2 = on_link(finger_.second_com, finger_.axis_offset, s2, c2);
  const Vector2d mass2 = joint2 + arm2;

  // The direction in which each coordinate moves the masses: both joints, then the base, which moves horizontally.
  const Vector2d level(std::cos(effects_.base_tilt), -std::sin(effects_.base_tilt));
  const Vector2d down(-std::sin(effects_.base_tilt), -std::cos(effects_.base_tilt));
  Eigen::Matrix<double, 2, 3> by1;
  Eigen::Matrix<double, 2, 3> by2;
  by1 << turned(mass1), Vector2d::Zero(), level;
  by2 << turned(mass2), turned(arm2), level;
  const double m1 = finger_.first_mass;
  const double m2 = finger_.second_mass + effects_.added_mass;

  Vector2d field = finger_.gravity * down;
  if (effects_.shake != 0.0)
    field -=
        effects_.shake * std::sin(2.0 * std::numbers::pi * effects_.shake_frequency * t + input.shake_phase) * level;
  const Vector2d centripetal1 = -first_rate * first_rate * mass1;
  const Vector2d centripetal2 = -first_rate * first_rate * joint2 - second_rate * second_rate * arm2;

  Balance out;
  out.inertia = m1 * by1.transpose() * by1 + m2 * by2.transpose() * by2;
  out.force = m1 * by1.transpose() * (field - centripetal1) + m2 * by2.transpose() * (field - centripetal2);
  out.force.head<2>() += joint_torques(state, t);
  if (effects_.mount_compliance > 0.0) {
    const double mass = (m1 + m2) / effects_.mount_compliance;
    const double pulsation = 2.0 * std::numbers::pi * effects_.mount_frequency;
    out.inertia(2, 2) += mass;
    out.force[2] -=
        mass * pulsation *
        (pulsation * state[StateIndex::mount] + 2.0 * effects_.mount_damping * state[StateIndex::mount + 1]);
  }
  return out;
}

Vector3d Dynamics::solve(const Balance& balance) const {
  Eigen::Matrix3d inertia = balance.inertia;
  Vector3d force = balance.force;
  const auto hold = [&](int coordinate) {
    inertia.row(coordinate).setZero();
    inertia.col(coordinate).setZero();
    inertia(coordinate, coordinate) = 1.0;
    force[coordinate] = 0.0;
  };
  if (effects_.mount_compliance <= 0.0) hold(2);
  if (effects_.friction > 0.0) {
    for (int j = 0; j < 2; ++j) force[j] -= effects_.friction * modes[j];
    for (int j = 0; j < 2; ++j)
      if (modes[j] == 0) hold(j);
  }
  return inertia.inverse() * force;
}

void Dynamics::operator()(const StateVector& state, StateVector& slope, double t) const {
  const Vector3d acceleration = solve(balance(state, t));
  slope.fill(0.0);
  for (int j = 0; j < 2; ++j) {
    const double rate = state[StateIndex::rate + j];
    slope[StateIndex::angle + j] = rate;
    slope[StateIndex::rate + j] = acceleration[j];
    if (effects_.creep_share != 0.0)
      slope[StateIndex::creep + j] =
          (state[StateIndex::angle + j] - state[StateIndex::creep + j]) / effects_.creep_time;
    if (effects_.hysteresis != 0.0)
      slope[StateIndex::hysteresis + j] =
          effects_.hysteresis_sharpness * (rate - std::abs(rate) * state[StateIndex::hysteresis + j]);
  }
  // The power of a coil under a given voltage is u i, proportional to the cold times the warm current. The power in a
  // magnet is proportional to the square of the warm current.
  const double cold_current = current(t);
  const double warm_current = cold_current / (1.0 + state[StateIndex::coil_heat]);
  if (effects_.coil_fade > 0.0)
    slope[StateIndex::coil_heat] =
        (effects_.coil_fade * cold_current * warm_current - state[StateIndex::coil_heat]) / effects_.coil_time;
  if (effects_.magnet_loss > 0.0)
    slope[StateIndex::magnet_heat] =
        (effects_.magnet_loss * warm_current * warm_current - state[StateIndex::magnet_heat]) / effects_.magnet_time;
  if (effects_.mount_compliance > 0.0) {
    slope[StateIndex::mount] = state[StateIndex::mount + 1];
    slope[StateIndex::mount + 1] = acceleration[2];
  }
}

std::array<double, 2> Dynamics::accelerations(const StateVector& state, double t) const {
  const Vector3d acceleration = solve(balance(state, t));
  return {acceleration[0], acceleration[1]};
}

std::array<double, 2> Dynamics::holding_torques(const StateVector& state, double t) const {
  const Balance all = balance(state, t);
  const Vector3d left_over = all.force - all.inertia * solve(all);
  std::array<double, 2> holding{};
  for (int j = 0; j < 2; ++j)
    if (modes[j] == 0) holding[j] = left_over[j];
  return holding;
}

Vector2d Dynamics::static_residual(const StateVector& state) const {
  return balance(state, input.since).force.head<2>();
}

StateVector Dynamics::settled(const Vector2d& angles) const {
  StateVector state{};
  for (int j = 0; j < 2; ++j) {
    state[StateIndex::angle + j] = angles[j];
    state[StateIndex::creep + j] = angles[j];
  }
  const double load = effects_.coil_fade * input.target * input.target;
  const double rise = 0.5 * (std::sqrt(1.0 + 4.0 * load) - 1.0);  // rise (1 + rise) = load
  const double warm_current = input.target / (1.0 + rise);
  state[StateIndex::coil_heat] = effects_.warm_start * rise;
  state[StateIndex::magnet_heat] = effects_.warm_start * effects_.magnet_loss * warm_current * warm_current;
  return state;
}

}  // namespace truth
