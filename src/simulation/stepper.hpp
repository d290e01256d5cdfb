#pragma once

#include <boost/numeric/odeint/algebra/default_operations.hpp>
#include <boost/numeric/odeint/algebra/range_algebra.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <optional>
#include <span>
#include <utility>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/algebra/smooth_curve.hpp"
#include "coilwright/simulation/state.hpp"
#include "held_joints.hpp"
#include "known_drive.hpp"
#include "packed_state.hpp"
#include "step_error.hpp"
#include "stiff_step.hpp"

namespace coilwright::simulation {

/// The model's equation of motion under an input that is constant or follows a curve, in steps of Dormand and Prince's
/// 5(4) pair (Boost.Odeint), and of a Rosenbrock method while faces are pressed together that would ring faster than
/// the motion changes.
class Stepper {
 public:
  struct Input {
    actuator::CoilCurrents currents;  ///< A
    mechanics::JointVector applied;   ///< N m
  };
  /// Bending angle (sum of the joint angles) and its derivatives at one time.
  struct Bending {
    double time{};          ///< s
    double angle{};         ///< rad
    double speed{};         ///< rad/s
    double acceleration{};  ///< rad/s^2
  };

  Stepper(const actuator::Model& model, const StepTolerance& tolerance);

  /// Starts anew at `time` from `state`; keeps the last step size as a first guess.
  void start(double time, const State& state, Input input) { start(time, state, std::move(input), std::nullopt); }
  /// The same under an input that follows a curve: the currents, then the torques
  /// if there are any. Steps are explicit then.
  void start(double time, const State& state, Input input, std::optional<algebra::SmoothCurve> curve);
  /// One accepted step; the span it covered is [previous_time(), time()]. It ends where faces meet or part and where a
  /// joint under dry friction stops or slips, so that no jump of the torques lies inside. A motion that has become
  /// infinite is accepted as it is: look at now().
  void step();
  /// The same, but to `end` (s, after time()) with ten times the error that it may have, unless an event comes before;
  /// shorter where that does not suffice.
  void step_to(double end);
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] double previous_time() const { return previous_time_; }
  /// State anywhere in the last step: the method's own continuous extension, of fourth order.
  [[nodiscard]] State at(double time) const;
  /// State at the end of the last step.
  [[nodiscard]] State now() const { return unpack(with_held_joints(packed(), time_)); }
  /// The same without its three vectors, for whoever looks at every step.
  [[nodiscard]] PackedState packed() const { return drive_.whole(values_, time_); }
  [[nodiscard]] Bending bending() const;

 private:
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<ExplicitPair, StepErrorChecker>;

  void take_step();
  void step_explicitly();
  [[nodiscard]] std::optional<HeldJoints::Change> first_friction_change(double end) const;
  void change_friction(const PackedState& whole, int slipping);
  [[nodiscard]] PackedState inside(double time) const;
  [[nodiscard]] PackedState with_held_joints(PackedState whole, double time) const;
  [[nodiscard]] PackedDerivative derivative_at(double time) const;
  [[nodiscard]] bool step_stiffly();  // false: nothing was done
  void advance();
  [[nodiscard]] algebra::SmoothCurve drive_ends() const;
  [[nodiscard]] Input input_at(double time) const;
  [[nodiscard]] double first_contact() const;  // in the last step; its end if there is none
  [[nodiscard]] double first_step() const;
  void shorten_step_after_rest();
  void derive(const PackedState& values, PackedState& slopes, double time) const;
  void derive_whole(const PackedState& values, PackedState& slopes, double time) const {
    derive_held(values, slopes, time, held_joints_.held());
  }
  void derive_held(const PackedState& values, PackedState& slopes, double time, std::span<const int> held) const;
  [[nodiscard]] State unpack(const PackedState& values) const;

  const actuator::Model& model_;
  StepErrorChecker error_checker_;
  Controlled controlled_;
  StiffStep stiff_;
  Input input_;
  std::optional<algebra::SmoothCurve> curve_;
  KnownDrive drive_;
  double time_ = 0.0;
  double previous_time_ = 0.0;
  double next_step_ = 1e-4;  // s; a hundredth of the fastest mode of a finger, adapted at once
  PackedState values_;       // without what is known of the drive
  PackedState slopes_;
  PackedState previous_values_;
  PackedState previous_slopes_;
  HeldJoints held_joints_;
  std::optional<HeldJoints::Change> friction_change_;  // at the end of the last step
  bool is_given_ = false;                              // the length of the next step
  bool last_was_stiff_ = false;
  bool contact_changed_ = false;  // at the end of the last step
};

}  // namespace coilwright::simulation
