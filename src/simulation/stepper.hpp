#pragma once

#include <boost/numeric/odeint.hpp>
#include <vector>

#include "coilwright/actuator/model.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// The model's equation of motion under a constant input, in steps with dense output. State layout: angles, then rates.
class Stepper {
 public:
  struct Input {
    actuator::CoilCurrents currents;
    mechanics::JointVector applied;
  };

  Stepper(const actuator::Model& model, double relative_accuracy);

  /// Starts anew at `time` from `state`; keeps the last step size as a first guess.
  void start(double time, const State& state, Input input);
  /// One accepted step; the span it covered is [previous_time(), time()].
  void step();
  [[nodiscard]] double time() const { return stepper_.current_time(); }
  [[nodiscard]] double previous_time() const { return stepper_.previous_time(); }
  /// State anywhere in the last step.
  [[nodiscard]] State at(double time);
  /// State at the end of the last step.
  [[nodiscard]] State now() const;

 private:
  using Values = std::vector<double>;
  using Dense =
      boost::numeric::odeint::result_of::make_dense_output<boost::numeric::odeint::runge_kutta_dopri5<Values>>::type;

  [[nodiscard]] State unpack(const Values& values) const;

  const actuator::Model& model_;
  Dense stepper_;
  Input input_;
  Values scratch_;
  double first_step_ = 1e-4;  // s; a hundredth of the fastest mode of a finger, adapted at once
};

}  // namespace coilwright::simulation
