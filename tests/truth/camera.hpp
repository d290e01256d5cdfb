#pragma once

namespace truth {

/// The angles that are recorded of a motion.
enum class Camera { bending_angle, joint_angles };

}  // namespace truth
