#include "truth/motion_integrator.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace truth {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double tolerance = 1e-9;      // of a step, rad and rad/s
constexpr double smallest_step = 1e-9;  // s: the integration passes an event by at least this much
constexpr double grazing = 1e-9;        // rad: a stop as close as this was met by the event just before
constexpr double largest_angle = 3.0;   // rad: no finger bends further

// Odeint copies the workspace of a stepper before it has written it; that of a static one is zero.
template <typename Stepper>
const Stepper& blank() {
  static const Stepper stepper;
  return stepper;
}

}  // namespace

MotionIntegrator::MotionIntegrator(Dynamics& dynamics, const StateVector& state)
    : dynamics_(dynamics),
      state_(state),
      plain_(blank<Stepper>()),
      controlled_(odeint::make_controlled(tolerance, tolerance, blank<Stepper>())) {}

void MotionIntegrator::integrate(double until) {
  settle_modes();
  while (until - time_ > 1e-13) step(until);
  time_ = until;
  for (const int j : {0, 1})
    if (!(std::abs(state_[StateIndex::angle + j]) < largest_angle))
      throw std::runtime_error("the simulated finger leaves the range of angles");
}

double MotionIntegrator::indicator(const Event& event, const StateVector& state, double t) const {
  const UnmodelledEffects& effects = dynamics_.effects();
  switch (event.kind) {
    case EventKind::sticks:
      return dynamics_.modes[event.joint] * state[StateIndex::rate + event.joint];
    case EventKind::breaks_away:
      return dynamics_.friction_at(0.0) - std::abs(dynamics_.holding_torques(state, t)[event.joint]);
    case EventKind::meets_stop:
      return state[StateIndex::angle + event.joint] - effects.stop_angle;
    case EventKind::meets_faces:
      return state[StateIndex::angle + event.joint] - dynamics_.finger().faces.angle;
    case EventKind::meets_seat:
      return std::abs(state[StateIndex::magnet + event.joint]) - 0.5 * effects.backlash;
  }
  return 0.0;
}

bool MotionIntegrator::happens(const Event& event, const StateVector& after, double t_after) const {
  const double end = indicator(event, after, t_after);
  if (!is_place(event.kind)) return end < 0.0;
  const double start = indicator(event, state_, time_);
  return std::abs(start) > grazing && (start < 0.0) != (end < 0.0);
}

void MotionIntegrator::step(double until) {
  StateVector after = state_;
  double t = time_;
  double length = std::min(next_length_, until - time_);
  const bool cut = length < next_length_;
  while (controlled_.try_step(std::ref(dynamics_), after, t, length) == boost::numeric::odeint::fail) {
    if (length < 1e-14)
      throw std::runtime_error("the integrator of the simulated finger needs steps that are too small");
  }
  next_length_ = cut ? std::max(next_length_, length) : length;
  next_length_ = std::min(next_length_, 0.05);
  const double length_taken = t - time_;
  const Event* first = nullptr;
  double when = length_taken;
  const bool has_friction = dynamics_.effects().friction > 0.0;
  std::array<Event, 8> possible{};
  int count = 0;
  for (int j = 0; j < 2; ++j) {
    if (has_friction) possible[count++] = {dynamics_.modes[j] == 0 ? EventKind::breaks_away : EventKind::sticks, j};
    if (dynamics_.effects().stop_stiffness > 0.0) possible[count++] = {EventKind::meets_stop, j};
    if (dynamics_.finger().faces.stiffness > 0.0) possible[count++] = {EventKind::meets_faces, j};
    if (dynamics_.effects().backlash > 0.0) possible[count++] = {EventKind::meets_seat, j};
  }
  for (int i = 0; i < count; ++i) {
    if (!happens(possible[i], after, t)) continue;
    const double at = locate(possible[i], length_taken);
    if (first == nullptr || at < when) {
      first = &possible[i];
      when = at;
    }
  }
  if (first == nullptr) {
    state_ = after;
    time_ = t;
    return;
  }
  plain_.do_step(std::ref(dynamics_), state_, time_, after, when);
  state_ = after;
  time_ += when;
  pass(*first);
}

// The time of the event after the start of a step of so many seconds. One plain step from the start reaches any time
// within.
double MotionIntegrator::locate(const Event& event, double length) {
  const auto after = [&](double part) {
    StateVector there;
    plain_.do_step(std::ref(dynamics_), state_, time_, there, part);
    return indicator(event, there, time_ + part);
  };
  const double shortest = std::min(smallest_step, 0.5 * length);
  const double at_shortest = after(shortest);
  const double at_end = after(length);
  if ((at_shortest < 0.0) == (at_end < 0.0)) return is_place(event.kind) ? length : shortest;
  std::uintmax_t iterations = 60;
  const auto [lower, upper] = boost::math::tools::toms748_solve(
      after, shortest, length, at_shortest, at_end, [](double a, double b) { return std::abs(b - a) < 1e-13; },
      iterations);
  return 0.5 * (lower + upper);
}

int MotionIntegrator::angle_of(const Event& event) {
  return (event.kind == EventKind::meets_seat ? StateIndex::magnet : StateIndex::angle) + event.joint;
}

void MotionIntegrator::pass(const Event& event) {
  if (event.kind == EventKind::sticks) {
    dynamics_.modes[event.joint] = 0;
    state_[StateIndex::rate + event.joint] = 0.0;
  }
  if (event.kind == EventKind::breaks_away)
    dynamics_.modes[event.joint] = dynamics_.holding_torques(state_, time_)[event.joint] > 0.0 ? 1 : -1;
  if (is_place(event.kind)) {  // moved slightly past it, so that the next step is on one side
    const int angle = angle_of(event);
    const int rate = angle + (event.kind == EventKind::meets_seat ? StateIndex::magnet_rate - StateIndex::magnet
                                                                  : StateIndex::rate - StateIndex::angle);
    state_[angle] += std::copysign(1e-12, state_[rate]);
  } else {
    settle_modes();
  }
}

// A joint at rest is either held by friction or slides in the direction in which it then accelerates.
void MotionIntegrator::settle_modes() {
  const double friction = dynamics_.friction_at(0.0);
  if (friction <= 0.0) return;
  const std::array<int, 2> before = dynamics_.modes;
  static constexpr std::array<int, 3> choices{0, 1, -1};
  for (const int first : choices)
    for (const int second : choices) {
      if (before[0] != 0 && first != before[0]) continue;
      if (before[1] != 0 && second != before[1]) continue;
      dynamics_.modes = {first, second};
      const std::array<double, 2> holding = dynamics_.holding_torques(state_, time_);
      const std::array<double, 2> speeding = dynamics_.accelerations(state_, time_);
      bool consistent = true;
      for (int j = 0; j < 2; ++j) {
        if (before[j] != 0) continue;
        if (dynamics_.modes[j] == 0) consistent = consistent && std::abs(holding[j]) <= friction;
        if (dynamics_.modes[j] != 0) consistent = consistent && speeding[j] * dynamics_.modes[j] > 0.0;
      }
      if (consistent) return;
    }
  dynamics_.modes = before;
  throw std::runtime_error("the friction of the simulated finger has no consistent mode");
}

}  // namespace truth
