#pragma once

#include <Eigen/Core>

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::simulation {

/// Angles and rates of a chain, base to tip, and the states of the model's effects.
struct State {
  mechanics::JointVector angles;  ///< rad
  mechanics::JointVector rates;   ///< rad/s
  /// Internal states of the effects, as Model::internal_states() counts them, each in its own unit; empty for a model
  /// without any. They are on the heap, unlike the rest, because a record holds many states and most models have none.
  Eigen::VectorXd internal{};
};

}  // namespace coilwright::simulation
