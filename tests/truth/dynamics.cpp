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
constexpr double iron_blur = 0.5;  // of the range: no iron is a point

Vector2d turned(const Vector2d& v) {
  return {-v.y(), v.x()};
}

// A point of a link (along, across) that makes `angle` with the vertical: the paper's (1), (2).
Vector2d on_link(double along, double across, double sine, double cosine) {
  return {along * sine - across * cosine, -along * cosine - across * sine};
}

}  // namespace

Dynamics::Dynamics(const Finger& finger, const Quirks& quirks) : finger_(finger), quirks_(quirks) {
  if (quirks_.stop_stiffness <= 0.0) return;
  // Nearly a third of critical on the inertia that a joint meets in the straight finger while the other gives way.
  const Eigen::Matrix2d mobility = balance({}, 0.0).inertia.topLeftCorner<2, 2>().inverse();
  for (int j = 0; j < 2; ++j)
    stop_damping_[j] = 2.0 * stop_damping_ratio * std::sqrt(quirks_.stop_stiffness / mobility(j, j));
}

double Dynamics::target(double command) const {
  double current = command;
  if (quirks_.deadband > 0.0) current = std::copysign(std::max(std::abs(current) - quirks_.deadband, 0.0), current);
  current = std::clamp(current, -quirks_.saturation, quirks_.saturation);
  return current + quirks_.current_offset;
}

double Dynamics::current(double t) const {
  if (quirks_.current_lag <= 0.0) return held.target;
  return held.target + (held.from - held.target) * std::exp(-(t - held.since) / quirks_.current_lag);
}

Vector2d Dynamics::joint_torques(const Phase& phase, double t) const {
  const double cold_current = current(t);
  const double warm_current = cold_current / (1.0 + phase[Slot::coil_heat]);
  const double strength = quirks_.force_gain * (1.0 - phase[Slot::magnet_heat]) * warm_current;
  Vector2d torques;
  for (int j = 0; j < 2; ++j) {
    const double angle = phase[Slot::angle + j];
    const double rate = phase[Slot::rate + j];
    const double per_ampere = quirks_.off_axis ? curves::exact(angle) : curves::line_of_centres(angle);
    double stiffness = finger_.stiffness * held.stiffness * (j == 1 ? quirks_.second_stiffness_ratio : 1.0);
    if (quirks_.mullins > 0.0)
      stiffness *=
          1.0 -
          quirks_.mullins * (1.0 - std::exp(-std::max(held.largest_angle[j], std::abs(angle)) / quirks_.mullins_angle));
    double torque = strength * per_ampere - stiffness * (angle - quirks_.rest_angle) -
                    stiffness * quirks_.hardening * angle * angle * angle - finger_.damping * rate + held.pull;
    torque -= quirks_.motional_conductance * per_ampere * per_ampere * rate;
    torque -= quirks_.drag * rate * std::abs(rate);
    torque -= quirks_.creep_share * stiffness * (angle - phase[Slot::creep + j]);
    torque -= quirks_.hysteresis * phase[Slot::hysteresis + j];
    if (quirks_.attraction != 0.0 && j == 0) {
      const double distance = 1.0 - quirks_.attraction_side * angle / quirks_.attraction_range;
      const double blur = iron_blur * iron_blur;
      torque += quirks_.attraction * std::pow((1.0 + blur) / (distance * distance + blur), 2);
    }
    if (quirks_.stop_stiffness > 0.0) {
      const double beyond = quirks_.stop_side * (angle - quirks_.stop_angle);
      const double deeper = quirks_.stop_side * rate;
      if (beyond > 0.0)
        torque -= quirks_.stop_side * std::max(quirks_.stop_stiffness * beyond + stop_damping_[j] * deeper, 0.0);
    }
    if (quirks_.ripple != 0.0) torque += quirks_.ripple * std::sin(quirks_.ripple_count * angle);
    torques[j] = torque;
  }
  if (quirks_.coil_coil) {
    const CoilCoilTorque between = curves::coil_coil(phase[Slot::angle], phase[Slot::angle + 1]);
    torques += warm_current * warm_current * Vector2d(between.first, between.second);
  }
  return torques;
}

Dynamics::Balance Dynamics::balance(const Phase& phase, double t) const {
  const double first = phase[Slot::angle];
  const double second = first + phase[Slot::angle + 1];
  const double first_rate = phase[Slot::rate];
  const double second_rate = first_rate + phase[Slot::rate + 1];
  const double s1 = std::sin(first);
  const double c1 = std::cos(first);
  const double s2 = std::sin(second);
  const double c2 = std::cos(second);
  const Vector2d mass1 = on_link(finger_.half_pitch, finger_.axis_offset, s1, c1);
  const Vector2d joint2 = on_link(2.0 * finger_.half_pitch, 0.0, s1, c1);
  const Vector2d arm2 = on_link(finger_.second_com, finger_.axis_offset, s2, c2);
  const Vector2d mass2 = joint2 + arm2;

  // What each coordinate moves: both joints, then the base, horizontally as the ground has it.
  const Vector2d level(std::cos(quirks_.base_tilt), -std::sin(quirks_.base_tilt));
  const Vector2d down(-std::sin(quirks_.base_tilt), -std::cos(quirks_.base_tilt));
  Eigen::Matrix<double, 2, 3> by1;
  Eigen::Matrix<double, 2, 3> by2;
  by1 << turned(mass1), Vector2d::Zero(), level;
  by2 << turned(mass2), turned(arm2), level;
  const double m1 = finger_.first_mass;
  const double m2 = finger_.second_mass + quirks_.added_mass;

  Vector2d field = finger_.gravity * down;
  if (quirks_.shake != 0.0)
    field -= quirks_.shake * std::sin(2.0 * std::numbers::pi * quirks_.shake_frequency * t + held.shake_phase) * level;
  const Vector2d centripetal1 = -first_rate * first_rate * mass1;
  const Vector2d centripetal2 = -first_rate * first_rate * joint2 - second_rate * second_rate * arm2;

  Balance out;
  out.inertia = m1 * by1.transpose() * by1 + m2 * by2.transpose() * by2;
  out.force = m1 * by1.transpose() * (field - centripetal1) + m2 * by2.transpose() * (field - centripetal2);
  out.force.head<2>() += joint_torques(phase, t);
  if (quirks_.mount_compliance > 0.0) {
    const double mass = (m1 + m2) / quirks_.mount_compliance;
    const double pulsation = 2.0 * std::numbers::pi * quirks_.mount_frequency;
    out.inertia(2, 2) += mass;
    out.force[2] -=
        mass * pulsation * (pulsation * phase[Slot::mount] + 2.0 * quirks_.mount_damping * phase[Slot::mount + 1]);
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
  if (quirks_.mount_compliance <= 0.0) hold(2);
  if (quirks_.friction > 0.0) {
    for (int j = 0; j < 2; ++j) force[j] -= quirks_.friction * modes[j];
    for (int j = 0; j < 2; ++j)
      if (modes[j] == 0) hold(j);
  }
  return inertia.inverse() * force;
}

void Dynamics::operator()(const Phase& phase, Phase& slope, double t) const {
  const Vector3d acceleration = solve(balance(phase, t));
  slope.fill(0.0);
  for (int j = 0; j < 2; ++j) {
    const double rate = phase[Slot::rate + j];
    slope[Slot::angle + j] = rate;
    slope[Slot::rate + j] = acceleration[j];
    if (quirks_.creep_share != 0.0)
      slope[Slot::creep + j] = (phase[Slot::angle + j] - phase[Slot::creep + j]) / quirks_.creep_time;
    if (quirks_.hysteresis != 0.0)
      slope[Slot::hysteresis + j] =
          quirks_.hysteresis_sharpness * (rate - std::abs(rate) * phase[Slot::hysteresis + j]);
  }
  // A coil under a given voltage takes u i: the cold current times the warm one. A magnet is warmed by what flows.
  const double cold_current = current(t);
  const double warm_current = cold_current / (1.0 + phase[Slot::coil_heat]);
  if (quirks_.coil_fade > 0.0)
    slope[Slot::coil_heat] =
        (quirks_.coil_fade * cold_current * warm_current - phase[Slot::coil_heat]) / quirks_.coil_time;
  if (quirks_.magnet_loss > 0.0)
    slope[Slot::magnet_heat] =
        (quirks_.magnet_loss * warm_current * warm_current - phase[Slot::magnet_heat]) / quirks_.magnet_time;
  if (quirks_.mount_compliance > 0.0) {
    slope[Slot::mount] = phase[Slot::mount + 1];
    slope[Slot::mount + 1] = acceleration[2];
  }
}

std::array<double, 2> Dynamics::accelerations(const Phase& phase, double t) const {
  const Vector3d acceleration = solve(balance(phase, t));
  return {acceleration[0], acceleration[1]};
}

std::array<double, 2> Dynamics::holding_torques(const Phase& phase, double t) const {
  const Balance all = balance(phase, t);
  const Vector3d left_over = all.force - all.inertia * solve(all);
  std::array<double, 2> holding{};
  for (int j = 0; j < 2; ++j)
    if (modes[j] == 0) holding[j] = left_over[j];
  return holding;
}

Vector2d Dynamics::static_residual(const Phase& phase) const {
  return balance(phase, held.since).force.head<2>();
}

Phase Dynamics::settled(const Vector2d& angles) const {
  Phase phase{};
  for (int j = 0; j < 2; ++j) {
    phase[Slot::angle + j] = angles[j];
    phase[Slot::creep + j] = angles[j];
  }
  const double load = quirks_.coil_fade * held.target * held.target;
  const double rise = 0.5 * (std::sqrt(1.0 + 4.0 * load) - 1.0);  // rise (1 + rise) = load
  const double warm_current = held.target / (1.0 + rise);
  phase[Slot::coil_heat] = quirks_.warm_start * rise;
  phase[Slot::magnet_heat] = quirks_.warm_start * quirks_.magnet_loss * warm_current * warm_current;
  return phase;
}

}  // namespace truth
