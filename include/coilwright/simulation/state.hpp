#pragma once

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::simulation {

/// Where a chain is and how it moves, base to tip.
struct State {
  mechanics::JointVector angles;  ///< rad
  mechanics::JointVector rates;   ///< rad/s
};

}  // namespace coilwright::simulation
