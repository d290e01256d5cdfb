#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// Ends of the integration steps of a transient, in each part between two changes of the input, s since that part
/// began.
using TransientSteps = std::vector<std::vector<double>>;

/// Accuracy of a transient: relative error of a step in every angle, rate and state of an effect, with a floor of 1e-9
/// rad, rad/s, or the SI unit of the effect's state (A, K, N m, or none).
struct Accuracy {
  double relative = 1e-7;
  /// Largest number of steps of a whole call, beside the limit between two changes of the input; for callers that
  /// prefer no answer to a slow one.
  double most_steps = std::numeric_limits<double>::infinity();
  /// Whether a motion that has come to rest under a held input is assumed to stay there until the input changes. A
  /// motion is at rest if it moves by less than twice the error of a step in a quarter of a second; with slow states
  /// (Model::has_slow_states) it never is.
  bool ends_at_rest = false;
  /// Steps to take: those of a neighbouring motion, so that the errors of the steps cancel in the difference. If they
  /// end too early, or have ten times the error of a step, the integrator chooses its own. Null: it always does.
  const TransientSteps* steps = nullptr;
  /// Receives the ends of the steps; null: they are not kept.
  TransientSteps* taken = nullptr;
  /// Called after each step with the time up to which the motion is known, s; on the caller's thread. May be empty.
  std::function<void(double time)> progress{};
};

/// The state at every sample of `input`, from `start` at the first. States of effects that `start` lacks are those of a
/// recorded run under the first input (InitialHistory::recorded_run).
///
/// The method is Dormand-Prince 5(4) with dense output (Boost.Odeint), and Rodas5P while faces are pressed together and
/// no effects act. A lag that is all of the drive's states (EffectTerm::lag) is computed in closed form where the input
/// is held or follows a curve. Steps end at samples only if the input has a step or a corner there. Throws
/// std::invalid_argument for an input that does not fit the model, std::runtime_error naming the time if the motion
/// cannot be followed (a joint beyond 180 degrees, or more than 1e6 steps between two changes of the input, plus 1e5
/// per second if effects have states).
[[nodiscard]] std::vector<State> simulate(const actuator::Model& model, const ModelInput& input, const State& start,
                                          const Accuracy& accuracy = {});

/// The motion at `times` (s, increasing) instead. All must lie between the first and the last sample of the input;
/// otherwise std::invalid_argument is thrown.
[[nodiscard]] std::vector<State> simulate_at(const actuator::Model& model, const ModelInput& input, const State& start,
                                             std::span<const double> times, const Accuracy& accuracy = {});

/// The motion as late as the camera shows it: at every sample of `input` the state model.delay() earlier, which is
/// `start` for the first samples. A camera shows model.observed(angle) for an angle.
[[nodiscard]] std::vector<State> simulate_as_observed(const actuator::Model& model, const ModelInput& input,
                                                      const State& start, const Accuracy& accuracy = {});

}  // namespace coilwright::simulation
