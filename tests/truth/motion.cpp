#include "truth/motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "truth/dynamics.hpp"
#include "truth/motion_integrator.hpp"
#include "truth/random.hpp"

namespace truth {
namespace {

// The state in equilibrium under the present input. Throws std::runtime_error if none is found.
StateVector rest(Dynamics& dynamics) {
  Eigen::Vector2d angles(0.4, 0.3);
  const auto residual = [&](const Eigen::Vector2d& at) { return dynamics.static_residual(dynamics.settled(at)); };
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Eigen::Vector2d left = residual(angles);
    if (left.norm() < 1e-15) break;
    Eigen::Matrix2d slope;
    constexpr double h = 1e-6;
    for (int j = 0; j < 2; ++j) {
      const Eigen::Vector2d by = h * Eigen::Vector2d::Unit(j);
      slope.col(j) = (residual(angles + by) - residual(angles - by)) / (2.0 * h);
    }
    Eigen::Vector2d move = -slope.inverse() * left;
    // If the step would go towards an unstable pose or too far: a short step along the torque instead.
    if (slope.trace() > 0.0 || slope.determinant() < 0.0 || !(move.norm() < 0.2)) move = 0.05 * left / left.norm();
    angles += move;
    if (move.norm() < 1e-13) break;
  }
  if (!(residual(angles).norm() < 1e-9)) throw std::runtime_error("the simulated finger has no equilibrium");
  return dynamics.settled(angles);
}

// The random events of one run, one value per sample of the input or per look of the camera.
struct RandomEvents {
  std::vector<double> current_share;
  std::vector<double> pull;
  std::vector<double> shown_at;  // s: the time that the camera shows in each look
  double shake_phase{};
};

// The push of the air is a random process with an exponential correlation (Ornstein and Uhlenbeck).
void add_gust(const UnmodelledEffects& effects, const Experiment& experiment, std::vector<double>& pull) {
  Random random(effects.chance + 0xD1B54A32D192ED03u * static_cast<std::uint64_t>(experiment.number + 1));
  double push = effects.gust * random.normal();
  double before = 0.0;
  for (std::size_t i = 0; i < pull.size(); ++i) {
    const double kept = std::exp(-(experiment.times[i] - before) / effects.gust_time);
    before = experiment.times[i];
    push = kept * push + effects.gust * std::sqrt(1.0 - kept * kept) * random.normal();
    pull[i] += push;
  }
}

RandomEvents draw(const UnmodelledEffects& effects, const Experiment& experiment) {
  Random random(effects.chance + 0x9E3779B97F4A7C15u * static_cast<std::uint64_t>(experiment.number + 1));
  RandomEvents events;
  events.shake_phase = 2.0 * std::numbers::pi * random.uniform();
  double pull = 0.0;
  double bad_until = -1.0;
  double frozen_until = -1.0;
  double shown = 0.0;
  double before = 0.0;
  const auto draw_input = [&](double time, double interval) {
    pull += effects.cable * std::sqrt(interval) * random.normal();
    if (random.uniform() < effects.contact_rate * interval) bad_until = time + 0.05;
    events.pull.push_back(pull);
    events.current_share.push_back(time < bad_until ? 1.0 - effects.contact_loss : 1.0);
  };
  const auto draw_look = [&](double time, double interval) {
    if (random.uniform() < effects.frozen_rate * interval)
      frozen_until = time - effects.frozen_frames * std::log(1.0 - random.uniform());
    const double jitter = effects.stamp_jitter * random.normal();
    if (effects.frozen_frames == 0.0 || time >= frozen_until) shown = std::max(shown, time + jitter);
    events.shown_at.push_back(std::max(shown - effects.delay, 0.0));
  };
  for (const double time : experiment.times) {
    draw_input(time, time - before);
    if (experiment.seen.empty()) draw_look(time, time - before);
    before = time;
  }
  before = 0.0;
  for (const double time : experiment.seen) {
    draw_look(time, time - before);
    before = time;
  }
  if (effects.gust > 0.0) add_gust(effects, experiment, events.pull);
  return events;
}

HeldInput held_input_at(const Dynamics& dynamics, const Experiment& experiment, const RandomEvents& events,
                        std::size_t sample) {
  HeldInput input;
  input.target = events.current_share[sample] * dynamics.target(experiment.currents[sample]);
  input.pull = events.pull[sample];
  input.stiffness = 1.0 - dynamics.effects().drift * experiment.session_time / 3600.0;
  input.shake_phase = events.shake_phase;
  input.disconnected = dynamics.is_disconnected(experiment.currents[sample]);
  return input;
}

// What the camera takes the joint angles for, without its scale and offset.
std::array<double, 2> shown_angles(const UnmodelledEffects& effects, const StateVector& state) {
  const int angle = effects.tracks() ? StateIndex::tracking : StateIndex::angle;
  std::array<double, 2> shown{state[angle], state[angle + 1]};
  if (effects.bend_share > 0.0) shown[1] += state[StateIndex::mount];
  if (effects.shutter_skew != 0.0) {
    const double bending = state[StateIndex::angle] + state[StateIndex::angle + 1];
    for (int j = 0; j < 2; ++j) shown[j] += effects.shutter_skew * bending * state[StateIndex::rate + j];
  }
  return shown;
}

// Calls `on_shown(time, state)` for every sample that the camera shows, in order.
template <typename OnShown>
void simulate_motion(const Finger& finger, const UnmodelledEffects& effects, const Experiment& experiment,
                     OnShown&& on_shown) {
  Dynamics dynamics(finger, effects, experiment.rig);
  const RandomEvents events = draw(effects, experiment);
  dynamics.input = held_input_at(dynamics, experiment, events, 0);
  dynamics.input.from = dynamics.input.target;
  MotionIntegrator integrator(dynamics, rest(dynamics));
  std::array<double, 2> largest{};
  double anchor = integrator.state()[StateIndex::angle];
  std::size_t shown = 0;
  const std::size_t samples = experiment.times.size();
  const std::size_t looks = events.shown_at.size();
  for (std::size_t i = 0; i < samples && shown < looks; ++i) {
    const double before = dynamics.current(experiment.times[i]);
    const double slope_before = dynamics.current_slope(experiment.times[i]);
    dynamics.input = held_input_at(dynamics, experiment, events, i);
    dynamics.input.since = experiment.times[i];
    dynamics.input.from = before;
    for (int j = 0; j < 2; ++j) largest[j] = std::max(largest[j], std::abs(integrator.state()[StateIndex::angle + j]));
    dynamics.input.from_slope = slope_before;
    dynamics.input.largest_angle = largest;
    const double first_angle = integrator.state()[StateIndex::angle];
    if (effects.cable_stiffness * std::abs(first_angle - anchor) > effects.cable_hold) anchor = first_angle;
    dynamics.input.anchor = anchor;
    // The input of the last sample is held until all samples are shown.
    const bool last = i + 1 == samples;
    while (shown < looks && (last || events.shown_at[shown] <= experiment.times[i + 1])) {
      integrator.integrate(events.shown_at[shown]);
      on_shown(events.shown_at[shown], integrator.state());
      ++shown;
    }
    if (!last) integrator.integrate(experiment.times[i + 1]);
  }
}

}  // namespace

std::array<double, 2> equilibrium(const Finger& finger, const UnmodelledEffects& effects, double current,
                                  const Rig& rig) {
  Dynamics dynamics(finger, effects, rig);
  dynamics.input.target = dynamics.input.from = dynamics.target(current);
  const StateVector state = rest(dynamics);
  return {state[StateIndex::angle], state[StateIndex::angle + 1]};
}

std::array<double, 2> accelerations(const Finger& finger, const UnmodelledEffects& effects, const State& state,
                                    double current, const Rig& rig) {
  Dynamics dynamics(finger, effects, rig);
  dynamics.input.target = dynamics.input.from = dynamics.target(current);
  StateVector full_state = dynamics.settled({state.angles[0], state.angles[1]});
  full_state[StateIndex::rate] = state.rates[0];
  full_state[StateIndex::rate + 1] = state.rates[1];
  return dynamics.accelerations(full_state, 0.0);
}

Trajectory simulate(const Finger& finger, const UnmodelledEffects& effects, const Experiment& experiment) {
  Trajectory out;
  simulate_motion(finger, effects, experiment,
                  [&](double, const StateVector& state) { out.push_back(shown_angles(effects, state)); });
  return out;
}

AngleRange angle_range_of(const Finger& finger, const std::vector<Experiment>& runs) {
  AngleRange range{.lowest = std::numeric_limits<double>::infinity(),
                   .highest = -std::numeric_limits<double>::infinity()};
  for (const Experiment& run : runs)
    for (const auto& angles : simulate(finger, {}, run))
      for (const double angle : angles) {
        range.lowest = std::min(range.lowest, angle);
        range.highest = std::max(range.highest, angle);
      }
  return range;
}

double peak_bending_rate(const Finger& finger, const UnmodelledEffects& effects, const Experiment& experiment) {
  double peak = 0.0;
  simulate_motion(finger, effects, experiment, [&](double, const StateVector& state) {
    peak = std::max(peak, state[StateIndex::rate] + state[StateIndex::rate + 1]);
  });
  return peak;
}

}  // namespace truth
