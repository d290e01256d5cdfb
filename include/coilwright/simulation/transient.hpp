#pragma once

#include <vector>

#include "coilwright/actuator/model.hpp"
#include "coilwright/simulation/input_signal.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// How exact a transient is: relative error of a step in every angle and rate, with a floor of 1e-9 rad and 1e-9 rad/s.
struct Accuracy {
  double relative = 1e-7;
};

/// The state at every sample of `input`, from `start` at the first. Dormand-Prince 5(4) with dense output
/// (Boost.Odeint); the steps do not see the samples unless the input changes there. Throws std::invalid_argument for an
/// input that does not fit the model, std::runtime_error naming the time where the motion cannot be followed (a joint
/// beyond 180 degrees, or more than 1e6 steps between two changes of the input).
[[nodiscard]] std::vector<State> simulate(const actuator::Model& model, const InputSignal& input, const State& start,
                                          const Accuracy& accuracy = {});

}  // namespace coilwright::simulation
