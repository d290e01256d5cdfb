#include "coilwright/simulation/initial_state.hpp"

#include <stdexcept>

#include "coilwright/simulation/equilibrium.hpp"

namespace coilwright::simulation {

using mechanics::JointVector;

std::optional<State> state_at_rest(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                   const JointVector& applied) {
  constexpr auto history = actuator::InitialHistory::recorded_run;
  const JointVector straight = JointVector::Zero(model.joints());
  const auto found = creep_to_equilibrium(
      {.residual =
           [&](const JointVector& at) { return JointVector(model.static_residual(at, currents, history) + applied); },
       .stiffness = [&](const JointVector& at) { return model.tangent_stiffness(at, currents, history); },
       .torque_scale = torque_scale(model)},
      straight);
  if (!found && model.coils() > 0) return std::nullopt;
  const JointVector& angles = found ? *found : straight;
  return State{.angles = angles, .rates = straight, .internal = model.settled(angles, currents, history)};
}

std::optional<State> equilibrium_at_first_input(const actuator::Model& model, const ModelInput& input) {
  return state_at_rest(model, input.currents.front(),
                       input.joint_torques.empty() ? JointVector::Zero(model.joints()) : input.joint_torques.front());
}

State start_of(const actuator::Model& model, const ModelInput& input, Start start, const std::string& who) {
  const std::optional<State> found = start == Start::no_current
                                         ? state_at_rest(model, model.all_coils(0.0), JointVector::Zero(model.joints()))
                                         : equilibrium_at_first_input(model, input);
  if (!found) throw std::runtime_error(who + ": has no stable pose under the first input to start from");
  return *found;
}

}  // namespace coilwright::simulation
