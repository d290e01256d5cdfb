#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// Ends of the steps of a transient, in each of its parts between two changes of the input, s since that part began.
using TransientSteps = std::vector<std::vector<double>>;

/// How exact a transient is: relative error of a step in every angle, rate and state of an effect, with a floor of 1e-9
/// rad, rad/s, or whatever SI unit the effect's state has (A, K, N m, or none).
struct Accuracy {
  double relative = 1e-7;
  /// Steps that a whole call may take before it gives up, besides the limit between two changes of the input; for
  /// callers that would rather have no answer than a slow one.
  double most_steps = std::numeric_limits<double>::infinity();
  /// Whether a motion that has come to rest under a held input is taken to stay there until the input changes. At rest
  /// is what moves by less than twice the error of a step in a quarter of a second; of effects with slow states
  /// (Model::has_slow_states) nothing is.
  bool ends_at_rest = false;
  /// Steps to take: those of a motion nearby, so that what sets both apart is not the difference of their errors. Where
  /// they do not suffice, or have ten times the error of a step, that decides again. Null: it decides alone.
  const TransientSteps* steps = nullptr;
  /// Where the ends of the steps are kept; null: nowhere.
  TransientSteps* taken = nullptr;
  /// Told after each step to which time the motion is known, s; on the caller's thread. May be empty.
  std::function<void(double time)> progress{};
};

/// The state at every sample of `input`, from `start` at the first; the states of effects, where `start` has none,
/// as a recorded run finds them there under the first input (InitialHistory::recorded_run). Dormand-Prince 5(4) with
/// dense output (Boost.Odeint), and Rodas5P while faces are pressed together and no effects act; a lag that is all the
/// drive's states (EffectTerm::lag) is taken in closed form where the input is held or goes along a curve. The steps do
/// not see the samples unless the input has a step or a corner there. Throws std::invalid_argument for an input that
/// does not fit the model, std::runtime_error naming the time where the motion cannot be followed (a joint beyond 180
/// degrees, or more than 1e6 steps between two changes of the input, 1e5 a second added where effects have states).
[[nodiscard]] std::vector<State> simulate(const actuator::Model& model, const ModelInput& input, const State& start,
                                          const Accuracy& accuracy = {});

/// The same motion at `times` (s, increasing) instead; each from the first to the last sample of the input, else
/// std::invalid_argument.
[[nodiscard]] std::vector<State> simulate_at(const actuator::Model& model, const ModelInput& input, const State& start,
                                             std::span<const double> times, const Accuracy& accuracy = {});

/// The same motion as old as the camera shows it: at every sample of `input` the state model.delay() earlier, which is
/// `start` for the first ones. What is shown of an angle is model.observed(angle).
[[nodiscard]] std::vector<State> simulate_as_observed(const actuator::Model& model, const ModelInput& input,
                                                      const State& start, const Accuracy& accuracy = {});

}  // namespace coilwright::simulation
