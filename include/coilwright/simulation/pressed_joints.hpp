#pragma once

#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::simulation {

/// The joints whose faces are pressed together at rest at `angles` (rad), counted from 0: magnets, weight or a current
/// hold them shut, and they do not bend.
[[nodiscard]] std::vector<int> pressed_joints(const actuator::Model& model, const mechanics::JointVector& angles);

/// What is to say of the joints that are pressed without current, and of those under it: "joints 2 and 3 are pressed
/// shut at this current, as without it: they do not bend". Empty where none is.
[[nodiscard]] std::string pressed_joints_text(std::span<const int> at_rest, std::span<const int> under_current);

/// "joint 2", "joints 2 and 3": counted from 1.
[[nodiscard]] std::string joints_text(std::span<const int> joints);

}  // namespace coilwright::simulation
