#include "measurement/replay/linear_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coilwright/algebra/exponential.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Model;
using simulation::State;

// A forward difference over this much has an error of a millionth from either side: of what bends, and of rounding.
constexpr double slope_step = 1e-6;

}  // namespace

DrivingInput input_at(const Model& model, const simulation::ModelInput& input, double time) {
  const auto after = std::ranges::upper_bound(input.times, time);
  const auto row = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - input.times.begin(), 1) - 1);
  const double share =
      input.goes_straight(row) ? (time - input.times[row]) / (input.times[row + 1] - input.times[row]) : 0.0;
  const std::size_t next = share > 0.0 ? row + 1 : row;
  DrivingInput out{.currents = (1.0 - share) * input.currents[row] + share * input.currents[next],
                   .torques = mechanics::JointVector::Zero(model.joints())};
  if (!input.joint_torques.empty())
    out.torques = (1.0 - share) * input.joint_torques[row] + share * input.joint_torques[next];
  return out;
}

Eigen::VectorXd slopes_of(const Model& model, const State& state, const DrivingInput& input) {
  const Eigen::Index joints = model.joints();
  Eigen::VectorXd out(size_of_changes(model));
  Eigen::VectorXd internal_slopes = Eigen::VectorXd::Zero(model.internal_states());
  mechanics::JointVector accelerations(joints);
  model.derivative(state.angles, state.rates, {state.internal.data(), static_cast<std::size_t>(state.internal.size())},
                   input.currents, input.torques, accelerations,
                   {internal_slopes.data(), static_cast<std::size_t>(internal_slopes.size())});
  out << state.rates, accelerations, internal_slopes;
  return out;
}

Eigen::Index size_of_changes(const Model& model) {
  return 2 * model.joints() + model.internal_states();
}

State displaced(State state, const Eigen::VectorXd& change) {
  const Eigen::Index joints = state.angles.size();
  state.angles += change.head(joints);
  state.rates += change.segment(joints, joints);
  if (state.internal.size() > 0) state.internal += change.tail(state.internal.size());
  return state;
}

LinearMotion linear_motion(const Model& model, const State& state, const DrivingInput& input,
                           std::span<const DrivingInput> units) {
  const Eigen::Index size = size_of_changes(model);
  const Eigen::VectorXd here = slopes_of(model, state, input);
  LinearMotion out{.by_state = Eigen::MatrixXd(size, size),
                   .by_input = Eigen::MatrixXd(size, static_cast<Eigen::Index>(units.size()))};
  Eigen::VectorXd change = Eigen::VectorXd::Zero(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index internal = i - 2 * model.joints();
    const double step = slope_step * (internal < 0 ? 1.0 : std::max(1.0, std::abs(state.internal[internal])));
    change[i] = step;
    out.by_state.col(i) = (slopes_of(model, displaced(state, change), input) - here) / step;
    change[i] = 0.0;
  }
  for (std::size_t c = 0; c < units.size(); ++c) {
    DrivingInput more = input;
    more.currents += slope_step * units[c].currents;
    more.torques += slope_step * units[c].torques;
    out.by_input.col(static_cast<Eigen::Index>(c)) = (slopes_of(model, state, more) - here) / slope_step;
  }
  return out;
}

void hold_joints(const Model& model, const State& state, LinearMotion& motion) {
  if (!model.holds_joints()) return;
  for (Eigen::Index j = 0; j < model.joints(); ++j) {
    if (state.rates[j] != 0.0) continue;
    for (const Eigen::Index row : {j, model.joints() + j}) {
      motion.by_state.row(row).setZero();
      motion.by_input.row(row).setZero();
    }
  }
}

LinearStep step_of(const LinearMotion& motion, double duration) {
  algebra::HeldResponse held = algebra::held_response(motion.by_state, duration);
  return {.transition = std::move(held.transition), .response = held.integral * motion.by_input};
}

}  // namespace coilwright::measurement::replay
