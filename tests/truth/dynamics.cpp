#include "truth/dynamics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "truth/torque_curves.hpp"

namespace truth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double stop_damping_ratio = 0.3;
constexpr double iron_blur = 0.5;  // share of the range: iron has an extent
// Friction that is a smooth function of the rate reaches three quarters of its torque at this rate, rad/s.
constexpr double creeping_rate = 0.3;
// A loose magnet on its seat: silicone gives way to it at this natural frequency, rad/s, with this damping ratio.
constexpr double seat_pulsation = 1200.0;
constexpr double seat_damping = 0.4;
constexpr double contact_width = 0.03;  // rad: of the angle over which a leak between the coils closes

Vector2d turned(const Vector2d& v) {
  return {-v.y(), v.x()};
}

Vector2d rates_of(const StateVector& state) {
  return {state[StateIndex::rate], state[StateIndex::rate + 1]};
}

// A point of a link (along, across) that makes `angle` with the vertical: the paper's (1), (2).
Vector2d on_link(double along, double across, double sine, double cosine) {
  return {along * sine - across * cosine, -along * cosine - across * sine};
}

}  // namespace

Dynamics::Dynamics(const Finger& finger, const UnmodelledEffects& effects, const Rig& rig)
    : finger_(finger), effects_(effects), rig_(rig) {
  if (effects_.mount_compliance > 0.0 && effects_.bend_share > 0.0)
    throw std::invalid_argument("simulated finger: must have a compliant mount or a bending segment; got both");
  effects_.base_tilt += rig_.base_turn;
  if (effects_.stop_stiffness <= 0.0 && effects_.backlash <= 0.0) return;
  // The effective inertia of a joint in the straight finger while the other is free is one over its mobility.
  const Eigen::Matrix2d mobility = balance({}, 0.0).inertia.topLeftCorner<2, 2>().inverse();
  for (int j = 0; j < 2; ++j) {
    // 0.3 of the critical damping.
    stop_damping_[j] = 2.0 * stop_damping_ratio * std::sqrt(effects_.stop_stiffness / mobility(j, j));
    if (effects_.backlash > 0.0) loose_inertia_[j] = effects_.backlash_inertia / mobility(j, j);
  }
}

bool Dynamics::is_disconnected(double command) const {
  return rig_.coil != CoilState::driven && command == 0.0;
}

// A driver keeps its current against the voltage that motion induces; a short does not.
double Dynamics::motional_conductance() const {
  if (!input.disconnected) return effects_.motional_conductance;
  if (rig_.coil == CoilState::open) return 0.0;
  return effects_.motional_conductance > 0.0 ? effects_.motional_conductance : 1.0 / finger_.coil_resistance;
}

double Dynamics::target(double command) const {
  if (is_disconnected(command)) return 0.0;
  double current = command;
  if (effects_.deadband > 0.0) current = std::copysign(std::max(std::abs(current) - effects_.deadband, 0.0), current);
  current = std::clamp(current, -effects_.saturation, effects_.saturation);
  return current + effects_.current_offset;
}

double Dynamics::current(double t) const {
  if (effects_.ringing_time > 0.0) return ringing(t).current;
  if (effects_.current_lag <= 0.0) return input.target;
  return input.target + (input.from - input.target) * std::exp(-(t - input.since) / effects_.current_lag);
}

// The step response of the second order: x + i y turns with the damped frequency and shrinks.
Dynamics::Ringing Dynamics::ringing(double t) const {
  const double pulsation = 1.0 / effects_.ringing_time;
  const double decay = effects_.ringing_damping * pulsation;
  const double damped = pulsation * std::sqrt(1.0 - effects_.ringing_damping * effects_.ringing_damping);
  const double a = input.from - input.target;
  const double b = (input.from_slope + decay * a) / damped;
  const double passed = t - input.since;
  const double left = std::exp(-decay * passed);
  const double cosine = std::cos(damped * passed);
  const double sine = std::sin(damped * passed);
  return {.current = input.target + left * (a * cosine + b * sine),
          .slope = left * ((damped * b - decay * a) * cosine - (damped * a + decay * b) * sine)};
}

double Dynamics::current_slope(double t) const {
  return effects_.ringing_time > 0.0 ? ringing(t).slope : 0.0;
}

double Dynamics::friction_at(double rate) const {
  if (effects_.stribeck_ratio == 1.0) return effects_.friction;
  const double share = rate / effects_.stribeck_rate;
  return effects_.friction * (1.0 + (effects_.stribeck_ratio - 1.0) * std::exp(-share * share));
}

double Dynamics::warm_current(const StateVector& state, double t) const {
  return current(t) / (1.0 + state[StateIndex::coil_heat]);
}

double Dynamics::torque_per_ampere(const StateVector& state, int joint) const {
  const double angle = state[StateIndex::angle + joint];
  const double per_ampere = effects_.off_axis ? curves::exact(angle) : curves::line_of_centres(angle);
  return per_ampere * (finger_.force_factor[joint] * (1.0 + curve_error(finger_.curve_error, angle)));
}

Vector2d Dynamics::drive_torques(const StateVector& state, double t) const {
  const double warm = warm_current(state, t);
  double strength = effects_.force_gain * (1.0 - state[StateIndex::magnet_heat]) * warm;
  strength *= 1.0 - effects_.iron_saturation * std::abs(warm);
  const double leak = effects_.contact_share == 0.0
                          ? 0.0
                          : effects_.contact_share /
                                (1.0 + std::exp((effects_.contact_angle - state[StateIndex::angle]) / contact_width));
  Vector2d torques;
  for (int j = 0; j < 2; ++j) {
    double drive = strength * (j == 0 ? 1.0 - leak : 1.0 + leak);
    if (effects_.magnet_shift != 0.0)
      drive *= 1.0 - effects_.magnet_shift * (1.0 - std::exp(-state[StateIndex::travel + j] / effects_.shift_travel));
    torques[j] = drive * torque_per_ampere(state, j);
  }
  return torques;
}

// Of a loose magnet on its joint, N m: a spring and a damper on either side of the gap, which push and never pull.
double Dynamics::seat_torque(const StateVector& state, int joint) const {
  const double from_middle = state[StateIndex::magnet + joint];
  const double side = from_middle < 0.0 ? -1.0 : 1.0;
  const double depth = std::abs(from_middle) - 0.5 * effects_.backlash;
  if (depth <= 0.0) return 0.0;
  const double deeper = side * state[StateIndex::magnet_rate + joint];
  return side * loose_inertia_[joint] *
         std::max(seat_pulsation * seat_pulsation * depth + 2.0 * seat_damping * seat_pulsation * deeper, 0.0);
}

Vector2d Dynamics::joint_torques(const StateVector& state, double t) const {
  const Vector2d drive = drive_torques(state, t);
  Vector2d torques;
  for (int j = 0; j < 2; ++j) {
    const double angle = state[StateIndex::angle + j];
    const double rate = state[StateIndex::rate + j];
    const double per_ampere = torque_per_ampere(state, j);
    double stiffness = finger_.stiffness * input.stiffness *
                       (j == 1 ? finger_.second_stiffness_ratio * effects_.second_stiffness_ratio : 1.0);
    const double damping = finger_.damping * (j == 1 ? finger_.second_damping_ratio : 1.0);
    if (effects_.mullins > 0.0)
      stiffness *=
          1.0 - effects_.mullins *
                    (1.0 - std::exp(-std::max(input.largest_angle[j], std::abs(angle)) / effects_.mullins_angle));
    double torque = (effects_.backlash > 0.0 ? seat_torque(state, j) : drive[j]) -
                    stiffness * (angle - effects_.rest_angle) - stiffness * effects_.hardening * angle * angle * angle -
                    damping * rate + input.pull;
    torque -= motional_conductance() * per_ampere * per_ampere * rate;
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
    if (finger_.faces.stiffness > 0.0 && angle < finger_.faces.angle)
      torque += std::max(finger_.faces.stiffness * (finger_.faces.angle - angle) - finger_.faces.damping * rate, 0.0);
    if (effects_.angle_friction != 0.0 || effects_.warm_friction != 0.0)
      torque -=
          (effects_.angle_friction * std::abs(angle) + effects_.warm_friction * state[StateIndex::friction_heat]) *
          std::tanh(rate / creeping_rate);
    torque -= effects_.joint_coupling * (angle - state[StateIndex::angle + 1 - j]);
    if (j == 0 && input.anchor) torque -= effects_.cable_stiffness * (angle - *input.anchor);
    if (effects_.ripple != 0.0) torque += effects_.ripple * std::sin(effects_.ripple_count * angle);
    torques[j] = torque;
  }
  if (effects_.coil_coil) {
    const CoilCoilTorque between = curves::coil_coil(state[StateIndex::angle], state[StateIndex::angle + 1]);
    const double warm = warm_current(state, t);
    torques += warm * warm * Vector2d(between.first, between.second);
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

  const double m1 = finger_.first_mass;
  const double m3 = (finger_.second_mass + effects_.added_mass) * effects_.bend_share;
  const double m2 = finger_.second_mass + effects_.added_mass - m3;

  // The direction in which each coordinate moves the masses: both joints, then the base, which moves horizontally.
  const Vector2d level(std::cos(effects_.base_tilt), -std::sin(effects_.base_tilt));
  const Vector2d down(-std::sin(effects_.base_tilt), -std::cos(effects_.base_tilt));
  Eigen::Matrix<double, 2, 3> by1;
  Eigen::Matrix<double, 2, 3> by2;
  const Vector2d third = m3 > 0.0 ? Vector2d::Zero() : level;
  by1 << turned(mass1), Vector2d::Zero(), third;
  by2 << turned(mass2), turned(arm2), third;

  Vector2d field = finger_.gravity * down;
  if (effects_.shake != 0.0)
    field -=
        effects_.shake * std::sin(2.0 * std::numbers::pi * effects_.shake_frequency * t + input.shake_phase) * level;
  const Vector2d centripetal1 = -first_rate * first_rate * mass1;
  const Vector2d centripetal2 = -first_rate * first_rate * joint2 - second_rate * second_rate * arm2;

  Balance out;
  out.inertia = m1 * by1.transpose() * by1 + m2 * by2.transpose() * by2;
  out.force = m1 * by1.transpose() * (field - centripetal1) + m2 * by2.transpose() * (field - centripetal2);
  if (rig_.tip_mass > 0.0) {
    const Vector2d arm = on_link(finger_.tip_length, 0.0, s2, c2);
    Eigen::Matrix<double, 2, 3> by_tip;
    by_tip << turned(joint2 + arm), turned(arm), third;
    const Vector2d centripetal = -first_rate * first_rate * joint2 - second_rate * second_rate * arm;
    out.inertia += rig_.tip_mass * by_tip.transpose() * by_tip;
    out.force += rig_.tip_mass * by_tip.transpose() * (field - centripetal);
  }
  out.force.head<2>() += joint_torques(state, t);
  for (int j = 0; j < 2; ++j) out.inertia(j, j) -= loose_inertia_[j];  // a loose magnet goes its own way
  if (m3 > 0.0) {  // this part of the tip segment turns about the second joint by a further angle
    const double bent = second + state[StateIndex::mount];
    const double bent_rate = second_rate + state[StateIndex::mount + 1];
    const Vector2d arm = on_link(finger_.second_com, finger_.axis_offset, std::sin(bent), std::cos(bent));
    Eigen::Matrix<double, 2, 3> by3;
    by3 << turned(joint2 + arm), turned(arm), turned(arm);
    const Vector2d centripetal = -first_rate * first_rate * joint2 - bent_rate * bent_rate * arm;
    out.inertia += m3 * by3.transpose() * by3;
    out.force += m3 * by3.transpose() * (field - centripetal);
    const double pulsation = 2.0 * std::numbers::pi * effects_.bend_frequency;
    out.force[2] -= m3 * arm.squaredNorm() * pulsation *
                    (pulsation * state[StateIndex::mount] + 2.0 * effects_.bend_damping * state[StateIndex::mount + 1]);
  }
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

Vector3d Dynamics::solve(const Balance& balance, const Vector2d& rates) const {
  Eigen::Matrix3d inertia = balance.inertia;
  Vector3d force = balance.force;
  const auto hold = [&](int coordinate) {
    inertia.row(coordinate).setZero();
    inertia.col(coordinate).setZero();
    inertia(coordinate, coordinate) = 1.0;
    force[coordinate] = 0.0;
  };
  if (effects_.mount_compliance <= 0.0 && effects_.bend_share <= 0.0) hold(2);
  if (effects_.friction > 0.0) {
    for (int j = 0; j < 2; ++j) force[j] -= friction_at(rates[j]) * modes[j];
    for (int j = 0; j < 2; ++j)
      if (modes[j] == 0) hold(j);
  }
  return inertia.inverse() * force;
}

void Dynamics::operator()(const StateVector& state, StateVector& slope, double t) const {
  const Vector3d acceleration = solve(balance(state, t), rates_of(state));
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
  if (effects_.backlash > 0.0) {
    const Vector2d drive = drive_torques(state, t);
    for (int j = 0; j < 2; ++j) {
      slope[StateIndex::magnet + j] = state[StateIndex::magnet_rate + j];
      slope[StateIndex::magnet_rate + j] = (drive[j] - seat_torque(state, j)) / loose_inertia_[j] - acceleration[j];
    }
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
  if (effects_.warm_friction != 0.0)
    slope[StateIndex::friction_heat] =
        (cold_current * cold_current - state[StateIndex::friction_heat]) / effects_.warm_friction_time;
  for (int j = 0; j < 2; ++j) {
    if (effects_.tracks())
      slope[StateIndex::tracking + j] =
          (state[StateIndex::angle + j] - state[StateIndex::tracking + j]) / effects_.tracking_time;
    if (effects_.magnet_shift != 0.0) slope[StateIndex::travel + j] = std::abs(state[StateIndex::rate + j]);
  }
  if (effects_.mount_compliance > 0.0 || effects_.bend_share > 0.0) {
    slope[StateIndex::mount] = state[StateIndex::mount + 1];
    slope[StateIndex::mount + 1] = acceleration[2];
  }
}

// The torque of gravity about the second joint beside that of the spring. The spring is far stiffer: each iteration
// leaves less than a fifth of the error.
double Dynamics::bent_by_gravity(double angle) const {
  const double pulsation = 2.0 * std::numbers::pi * effects_.bend_frequency;
  const Vector2d down(-std::sin(effects_.base_tilt), -std::cos(effects_.base_tilt));
  double bent = 0.0;
  for (int i = 0; i < 16; ++i) {
    const Vector2d arm =
        on_link(finger_.second_com, finger_.axis_offset, std::sin(angle + bent), std::cos(angle + bent));
    bent = finger_.gravity * turned(arm).dot(down) / (arm.squaredNorm() * pulsation * pulsation);
  }
  return bent;
}

std::array<double, 2> Dynamics::accelerations(const StateVector& state, double t) const {
  const Vector3d acceleration = solve(balance(state, t), rates_of(state));
  return {acceleration[0], acceleration[1]};
}

std::array<double, 2> Dynamics::holding_torques(const StateVector& state, double t) const {
  const Balance all = balance(state, t);
  const Vector3d left_over = all.force - all.inertia * solve(all, rates_of(state));
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
    if (effects_.tracks()) state[StateIndex::tracking + j] = angles[j];
  }
  if (effects_.warm_friction != 0.0) state[StateIndex::friction_heat] = input.target * input.target;
  if (effects_.bend_share > 0.0) state[StateIndex::mount] = bent_by_gravity(angles.sum());
  const double load = effects_.coil_fade * input.target * input.target;
  const double rise = 0.5 * (std::sqrt(1.0 + 4.0 * load) - 1.0);  // rise (1 + rise) = load
  const double warm_current = input.target / (1.0 + rise);
  state[StateIndex::coil_heat] = effects_.warm_start * rise;
  state[StateIndex::magnet_heat] = effects_.warm_start * effects_.magnet_loss * warm_current * warm_current;
  if (effects_.backlash > 0.0) {  // in the middle where nothing pushes them
    const Vector2d drive = drive_torques(state, input.since);
    for (int j = 0; j < 2; ++j)
      if (drive[j] != 0.0)
        state[StateIndex::magnet + j] = std::copysign(0.5 * effects_.backlash, drive[j]) +
                                        drive[j] / (loose_inertia_[j] * seat_pulsation * seat_pulsation);
  }
  return state;
}

}  // namespace truth
