#pragma once

#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator::effects {

/// Acceleration of each joint by a torque of its own while the others are free to give way: the diagonal of the inverse
/// mass matrix at zero angles, 1/(kg m^2), > 0. How stiff a regularisation may be on this rig follows from it.
[[nodiscard]] mechanics::JointVector joint_mobility(const mechanics::PlanarChain& chain);

}  // namespace coilwright::actuator::effects
