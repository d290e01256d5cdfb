#pragma once

#include <optional>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/actuator/operating_point.hpp"

namespace coilwright::simulation {

/// A finger that rests against a vertical wall without friction and cannot bend further.
struct BlockedGrasp {
  double force{};                 ///< on the wall, N, >= 0; 0 if the finger would leave the wall
  mechanics::JointVector angles;  ///< of the joints while it presses, rad
};

/// Distance of the wall of `grasp` from the straight finger's hinge line, m: x of the point of contact with each joint
/// at its share of the opening.
[[nodiscard]] double wall_position(const actuator::Model& model, const actuator::GraspPoint& grasp);

/// Static equilibrium of the finger on the wall of `grasp`; by default the finger is straight with its tip on the wall.
/// Absent if the finger creeps to none from the pose in which it just touches. Joints may turn as far as the wall and
/// their contacts allow. Throws std::invalid_argument for an opening or a height that is not finite and >= 0, a height
/// beyond the tip, and an opening beyond which the contact of an evenly bent finger moves back towards the straight
/// finger (96.5 deg with the paper's finger).
[[nodiscard]] std::optional<BlockedGrasp> blocked_grasp(const actuator::Model& model,
                                                        const actuator::CoilCurrents& currents,
                                                        const actuator::GraspPoint& grasp = {});

}  // namespace coilwright::simulation
