#pragma once

#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::simulation {

/// The joints, counted from 0, whose faces are pressed together at rest at `angles` (rad): magnets, weight or a current
/// hold them shut, and they do not bend.
[[nodiscard]] std::vector<int> pressed_joints(const actuator::Model& model, const mechanics::JointVector& angles);

/// A remark on the joints that are pressed without current, and on those under it: "joints 2 and 3 are pressed shut at
/// this current, as without it: they do not bend". Empty if none is.
[[nodiscard]] std::string pressed_joints_text(std::span<const int> at_rest, std::span<const int> under_current);

/// Joints in words, counted from 1: "joint 2", "joints 2 and 3".
[[nodiscard]] std::string joints_text(std::span<const int> joints);

}  // namespace coilwright::simulation
