#pragma once

#include <optional>
#include <string>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// The state in which `model` rests under constant `currents` (A) and further joint torques `applied` (N m), as a
/// recorded run begins: in stable equilibrium, with every internal state as in InitialHistory::recorded_run. A model
/// without coils and without a stable pose (no springs, no gravity) stays straight. Absent if a model with coils has no
/// stable pose within reach of the straight one.
[[nodiscard]] std::optional<State> state_at_rest(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                                 const mechanics::JointVector& applied);

/// The state at the first sample of `input` of a run that starts at rest. Simulations, replays of measured runs and
/// synthetic data all start here.
[[nodiscard]] std::optional<State> equilibrium_at_first_input(const actuator::Model& model, const ModelInput& input);

/// The start of a simulation: at rest under the first sample, or, for a step from there, without current.
enum class Start { first_input, no_current };

/// The state at that start. Throws std::runtime_error if there is none: `who` has no stable pose to start from.
[[nodiscard]] State start_of(const actuator::Model& model, const ModelInput& input, Start start,
                             const std::string& who);

}  // namespace coilwright::simulation
