#pragma once

#include <Eigen/Core>

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::simulation {

/// Where a chain is and how it moves, base to tip, and the states of the model's effects.
struct State {
  mechanics::JointVector angles;  ///< rad
  mechanics::JointVector rates;   ///< rad/s
  /// As Model::internal_states() counts them, each in its own unit; empty for a model without. On the heap, unlike the
  /// rest: a record of a motion holds many states, and most models have none.
  Eigen::VectorXd internal{};
};

}  // namespace coilwright::simulation
