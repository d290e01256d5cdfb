#pragma once

#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "truth/dynamics.hpp"

namespace truth {

/// Integrates the equations of motion and locates the events at which a joint sticks, breaks away or meets its stop
/// or its faces.
class MotionIntegrator {
 public:
  /// Refers to `dynamics`, whose friction modes it sets.
  MotionIntegrator(Dynamics& dynamics, const StateVector& state);

  [[nodiscard]] const StateVector& state() const { return state_; }

  /// Integrates until that time, s. Throws std::runtime_error if a joint leaves the range in which a finger can bend.
  void integrate(double until);

 private:
  using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<StateVector>;
  enum class EventKind { sticks, breaks_away, meets_stop, meets_faces, meets_seat };
  /// Whether it happens at an angle, in either direction.
  [[nodiscard]] static bool is_place(EventKind kind) { return kind >= EventKind::meets_stop; }
  struct Event {
    EventKind kind;
    int joint;
  };

  [[nodiscard]] double indicator(const Event& event, const StateVector& state, double t) const;
  /// Of the state vector: the angle that an event at a place is about.
  [[nodiscard]] static int angle_of(const Event& event);
  [[nodiscard]] bool happens(const Event& event, const StateVector& after, double t_after) const;
  [[nodiscard]] double locate(const Event& event, double length);
  void step(double until);
  void pass(const Event& event);
  void settle_modes();

  Dynamics& dynamics_;
  StateVector state_;
  double time_ = 0.0;
  double next_length_ = 1e-3;  // s, of the next step
  Stepper plain_;
  boost::numeric::odeint::result_of::make_controlled<Stepper>::type controlled_;
};

}  // namespace truth
