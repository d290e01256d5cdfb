#include "truth/motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "truth/dynamics.hpp"
#include "truth/random.hpp"

namespace truth {
namespace {

namespace odeint = boost::numeric::odeint;
using Stepper = odeint::runge_kutta_fehlberg78<Phase>;

constexpr double tolerance = 1e-9;      // a step, rad and rad/s
constexpr double smallest_step = 1e-9;  // s: an event is passed by at least this much
constexpr double grazing = 1e-9;        // rad: a stop touched this closely was met by an event just before
constexpr double furthest = 3.0;        // rad: no finger bends so far

// Odeint copies a stepper's workspace before it has written it; a static one is at least zero.
const Stepper& blank() {
  static const Stepper stepper;
  return stepper;
}

// Moves a phase through time and stops where a joint sticks, breaks loose or meets its stop.
class Traveller {
 public:
  Traveller(Dynamics& dynamics, const Phase& phase) : dynamics_(dynamics), phase_(phase) {}

  [[nodiscard]] const Phase& phase() const { return phase_; }

  void go(double until) {
    settle_modes();
    while (until - time_ > 1e-13) step(until);
    time_ = until;
    for (const int j : {0, 1})
      if (!(std::abs(phase_[Slot::angle + j]) < furthest))
        throw std::runtime_error("the finger of the truth flies off");
  }

 private:
  enum class Kind { sticks, breaks, stop };
  struct Event {
    Kind kind;
    int joint;
  };

  [[nodiscard]] double indicator(const Event& event, const Phase& phase, double t) const {
    const Quirks& quirks = dynamics_.quirks();
    switch (event.kind) {
      case Kind::sticks:
        return dynamics_.modes[event.joint] * phase[Slot::rate + event.joint];
      case Kind::breaks:
        return quirks.friction - std::abs(dynamics_.holding_torques(phase, t)[event.joint]);
      case Kind::stop:
        return phase[Slot::angle + event.joint] - quirks.stop_angle;
    }
    return 0.0;
  }

  [[nodiscard]] bool happens(const Event& event, const Phase& after, double t_after) const {
    const double end = indicator(event, after, t_after);
    if (event.kind != Kind::stop) return end < 0.0;
    const double start = indicator(event, phase_, time_);
    return std::abs(start) > grazing && (start < 0.0) != (end < 0.0);
  }

  void step(double until) {
    Phase after = phase_;
    double t = time_;
    double length = std::min(guess_, until - time_);
    const bool cut = length < guess_;
    while (controlled_.try_step(std::ref(dynamics_), after, t, length) == odeint::fail) {
      if (length < 1e-14) throw std::runtime_error("the integrator of the truth cannot go on");
    }
    guess_ = cut ? std::max(guess_, length) : length;
    guess_ = std::min(guess_, 0.05);
    const double took = t - time_;
    const Event* first = nullptr;
    double when = took;
    const bool rubs = dynamics_.quirks().friction > 0.0;
    std::array<Event, 4> possible{};
    int count = 0;
    for (int j = 0; j < 2; ++j) {
      if (rubs) possible[count++] = {dynamics_.modes[j] == 0 ? Kind::breaks : Kind::sticks, j};
      if (dynamics_.quirks().stop_stiffness > 0.0) possible[count++] = {Kind::stop, j};
    }
    for (int i = 0; i < count; ++i) {
      if (!happens(possible[i], after, t)) continue;
      const double at = locate(possible[i], took);
      if (first == nullptr || at < when) {
        first = &possible[i];
        when = at;
      }
    }
    if (first == nullptr) {
      phase_ = after;
      time_ = t;
      return;
    }
    plain_.do_step(std::ref(dynamics_), phase_, time_, after, when);
    phase_ = after;
    time_ += when;
    pass(*first);
  }

  // How far into a step of `took` seconds the event lies. One plain step from the start reaches any point within.
  [[nodiscard]] double locate(const Event& event, double took) {
    const auto after = [&](double length) {
      Phase there;
      plain_.do_step(std::ref(dynamics_), phase_, time_, there, length);
      return indicator(event, there, time_ + length);
    };
    const double shortest = std::min(smallest_step, 0.5 * took);
    const double at_shortest = after(shortest);
    const double at_end = after(took);
    if ((at_shortest < 0.0) == (at_end < 0.0)) return event.kind == Kind::stop ? took : shortest;
    std::uintmax_t iterations = 60;
    const auto [lower, upper] = boost::math::tools::toms748_solve(
        after, shortest, took, at_shortest, at_end, [](double a, double b) { return std::abs(b - a) < 1e-13; },
        iterations);
    return 0.5 * (lower + upper);
  }

  void pass(const Event& event) {
    if (event.kind == Kind::sticks) {
      dynamics_.modes[event.joint] = 0;
      phase_[Slot::rate + event.joint] = 0.0;
    }
    if (event.kind == Kind::breaks)
      dynamics_.modes[event.joint] = dynamics_.holding_torques(phase_, time_)[event.joint] > 0.0 ? 1 : -1;
    if (event.kind == Kind::stop)  // a hair past it: what follows is all on one side
      phase_[Slot::angle + event.joint] += std::copysign(1e-12, phase_[Slot::rate + event.joint]);
    else
      settle_modes();
  }

  // Every joint that stands still either is held or slides off in the direction in which it then accelerates.
  void settle_modes() {
    const double friction = dynamics_.quirks().friction;
    if (friction <= 0.0) return;
    const std::array<int, 2> before = dynamics_.modes;
    static constexpr std::array<int, 3> choices{0, 1, -1};
    for (const int first : choices)
      for (const int second : choices) {
        if (before[0] != 0 && first != before[0]) continue;
        if (before[1] != 0 && second != before[1]) continue;
        dynamics_.modes = {first, second};
        const std::array<double, 2> holding = dynamics_.holding_torques(phase_, time_);
        const std::array<double, 2> speeding = dynamics_.accelerations(phase_, time_);
        bool consistent = true;
        for (int j = 0; j < 2; ++j) {
          if (before[j] != 0) continue;
          if (dynamics_.modes[j] == 0) consistent = consistent && std::abs(holding[j]) <= friction;
          if (dynamics_.modes[j] != 0) consistent = consistent && speeding[j] * dynamics_.modes[j] > 0.0;
        }
        if (consistent) return;
      }
    dynamics_.modes = before;
    throw std::runtime_error("friction of the truth finds no consistent mode");
  }

  Dynamics& dynamics_;
  Phase phase_;
  double time_ = 0.0;
  double guess_ = 1e-3;
  Stepper plain_ = blank();
  odeint::result_of::make_controlled<Stepper>::type controlled_ =
      odeint::make_controlled(tolerance, tolerance, blank());
};

Phase rest(Dynamics& dynamics) {
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
    // uphill (a joint that would run away) or too far: a short way along the torque instead
    if (slope.trace() > 0.0 || slope.determinant() < 0.0 || !(move.norm() < 0.2)) move = 0.05 * left / left.norm();
    angles += move;
    if (move.norm() < 1e-13) break;
  }
  if (!(residual(angles).norm() < 1e-9)) throw std::runtime_error("the truth finds no equilibrium");
  return dynamics.settled(angles);
}

// What chance holds ready for one run.
struct Fate {
  std::vector<double> current_share;
  std::vector<double> pull;
  std::vector<double> shown_at;  // s: the instant that the camera shows in each sample
  double shake_phase{};
};

Fate draw(const Quirks& quirks, const Experiment& experiment) {
  Random random(quirks.chance + 0x9E3779B97F4A7C15u * static_cast<std::uint64_t>(experiment.number + 1));
  Fate fate;
  fate.shake_phase = 2.0 * std::numbers::pi * random.uniform();
  double pull = 0.0;
  double bad_until = -1.0;
  double frozen_until = -1.0;
  double shown = 0.0;
  double before = 0.0;
  for (const double time : experiment.times) {
    const double interval = time - before;
    before = time;
    pull += quirks.cable * std::sqrt(interval) * random.normal();
    if (random.uniform() < quirks.contact_rate * interval) bad_until = time + 0.05;
    if (random.uniform() < quirks.frozen_rate * interval)
      frozen_until = time - quirks.frozen_frames * std::log(1.0 - random.uniform());
    const double jitter = quirks.stamp_jitter * random.normal();
    fate.pull.push_back(pull);
    fate.current_share.push_back(time < bad_until ? 1.0 - quirks.contact_loss : 1.0);
    if (quirks.frozen_frames == 0.0 || time >= frozen_until) shown = std::max(shown, time + jitter);
    fate.shown_at.push_back(std::max(shown - quirks.delay, 0.0));
  }
  return fate;
}

Held held_at(const Dynamics& dynamics, const Experiment& experiment, const Fate& fate, std::size_t sample) {
  Held held;
  held.target = fate.current_share[sample] * dynamics.target(experiment.currents[sample]);
  held.pull = fate.pull[sample];
  held.stiffness = 1.0 - dynamics.quirks().drift * experiment.session_time / 3600.0;
  held.shake_phase = fate.shake_phase;
  return held;
}

// Calls `see(time, phase)` at every instant that the camera shows, in order.
template <typename See>
void travel(const Finger& finger, const Quirks& quirks, const Experiment& experiment, See&& see) {
  Dynamics dynamics(finger, quirks);
  const Fate fate = draw(quirks, experiment);
  dynamics.held = held_at(dynamics, experiment, fate, 0);
  dynamics.held.from = dynamics.held.target;
  Traveller traveller(dynamics, rest(dynamics));
  std::array<double, 2> largest{};
  std::size_t shown = 0;
  const std::size_t samples = experiment.times.size();
  for (std::size_t i = 0; i < samples && shown < samples; ++i) {
    const double before = dynamics.current(experiment.times[i]);
    dynamics.held = held_at(dynamics, experiment, fate, i);
    dynamics.held.since = experiment.times[i];
    dynamics.held.from = before;
    for (int j = 0; j < 2; ++j) largest[j] = std::max(largest[j], std::abs(traveller.phase()[Slot::angle + j]));
    dynamics.held.largest_angle = largest;
    // the last sample's input is held until all is shown
    const bool last = i + 1 == samples;
    while (shown < samples && (last || fate.shown_at[shown] <= experiment.times[i + 1])) {
      traveller.go(fate.shown_at[shown]);
      see(fate.shown_at[shown], traveller.phase());
      ++shown;
    }
    if (!last) traveller.go(experiment.times[i + 1]);
  }
}

}  // namespace

std::array<double, 2> equilibrium(const Finger& finger, const Quirks& quirks, double current) {
  Dynamics dynamics(finger, quirks);
  dynamics.held.target = dynamics.held.from = dynamics.target(current);
  const Phase phase = rest(dynamics);
  return {phase[Slot::angle], phase[Slot::angle + 1]};
}

std::array<double, 2> accelerations(const Finger& finger, const Quirks& quirks, const State& state, double current) {
  Dynamics dynamics(finger, quirks);
  dynamics.held.target = dynamics.held.from = dynamics.target(current);
  Phase phase = dynamics.settled({state.angles[0], state.angles[1]});
  phase[Slot::rate] = state.rates[0];
  phase[Slot::rate + 1] = state.rates[1];
  return dynamics.accelerations(phase, 0.0);
}

Record record(const Finger& finger, const Quirks& quirks, const Experiment& experiment) {
  Record out;
  travel(finger, quirks, experiment, [&](double, const Phase& phase) {
    out.push_back({phase[Slot::angle], phase[Slot::angle + 1]});
  });
  return out;
}

Reach reach_of(const Finger& finger, const std::vector<Experiment>& runs) {
  Reach reach{.lowest = std::numeric_limits<double>::infinity(), .highest = -std::numeric_limits<double>::infinity()};
  for (const Experiment& run : runs)
    for (const auto& angles : record(finger, {}, run))
      for (const double angle : angles) {
        reach.lowest = std::min(reach.lowest, angle);
        reach.highest = std::max(reach.highest, angle);
      }
  return reach;
}

double peak_bending_rate(const Finger& finger, const Quirks& quirks, const Experiment& experiment) {
  double peak = 0.0;
  travel(finger, quirks, experiment,
         [&](double, const Phase& phase) { peak = std::max(peak, phase[Slot::rate] + phase[Slot::rate + 1]); });
  return peak;
}

}  // namespace truth
