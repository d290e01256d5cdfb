#pragma once

#include <Eigen/Core>
#include <span>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::measurement::replay {

/// What drives a model at one time, or one unit of a column of its input.
struct DrivingInput {
  actuator::CoilCurrents currents;  ///< A
  mechanics::JointVector torques;   ///< N m
};

/// What an input is at a time, s, from that of its first row on.
[[nodiscard]] DrivingInput input_at(const actuator::Model& model, const simulation::ModelInput& input, double time);

/// Number of small changes of a state: of angles, rates and states of effects, in this order.
[[nodiscard]] Eigen::Index size_of_changes(const actuator::Model& model);

/// The state with its numbers displaced.
[[nodiscard]] simulation::State displaced(simulation::State state, const Eigen::VectorXd& change);

/// How fast the state changes: its rates, accelerations and the slopes of the states of effects.
[[nodiscard]] Eigen::VectorXd slopes_of(const actuator::Model& model, const simulation::State& state,
                                        const DrivingInput& input);

/// The equation of motion about a state, to first order: small changes x of the state, while small changes u of the
/// input's columns act, move by x' = by_state x + by_input u.
struct LinearMotion {
  Eigen::MatrixXd by_state{};  ///< (size_of_changes, size_of_changes)
  Eigen::MatrixXd by_input{};  ///< (size_of_changes, columns)
};

/// By forward differences of Model::derivative; `units` is what one unit of each column is. At a corner of the equation
/// (faces that just meet) that of the side to which the differences lead.
[[nodiscard]] LinearMotion linear_motion(const actuator::Model& model, const simulation::State& state,
                                         const DrivingInput& input, std::span<const DrivingInput> units);

/// Takes from a linear motion what joints would do that dry friction holds at rest in that state: nothing.
void hold_joints(const actuator::Model& model, const simulation::State& state, LinearMotion& motion);

/// What becomes of small changes in a time: x of its end is transition x + response u, while u is held.
struct LinearStep {
  Eigen::MatrixXd transition{};  ///< (size_of_changes, size_of_changes)
  Eigen::MatrixXd response{};    ///< (size_of_changes, columns)
};

/// Over a `duration`, s, in which the linear motion hardly changes.
[[nodiscard]] LinearStep step_of(const LinearMotion& motion, double duration);

}  // namespace coilwright::measurement::replay
