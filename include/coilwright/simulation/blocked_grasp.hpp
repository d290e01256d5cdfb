#pragma once

#include <optional>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/actuator/operating_point.hpp"

namespace coilwright::simulation {

/// The finger rests against a vertical wall without friction and cannot bend further.
struct BlockedGrasp {
  double force{};                 ///< on the wall, N, >= 0; 0 where the finger would rather leave the wall
  mechanics::JointVector angles;  ///< of the joints while it presses, rad
};

/// Distance of the wall of `grasp` from the straight finger's hinge line, m: x of the point of contact with every joint
/// at its share of the opening.
[[nodiscard]] double wall_position(const actuator::Model& model, const actuator::GraspPoint& grasp);

/// Static equilibrium of the finger on the wall of `grasp`, by default straight with its tip on it; nothing if there is
/// none that the finger creeps to from the pose in which it just touches. Joints may turn as far as the wall and their
/// contacts let them. Throws std::invalid_argument for an opening or a height that is not finite and >= 0, a height
/// beyond the tip, and an opening from where on the contact of a finger that bends in all joints alike comes back
/// towards the straight finger (beyond 96.5 deg with the paper's finger): it would have gone through the wall before.
[[nodiscard]] std::optional<BlockedGrasp> blocked_grasp(const actuator::Model& model,
                                                        const actuator::CoilCurrents& currents,
                                                        const actuator::GraspPoint& grasp = {});

}  // namespace coilwright::simulation
