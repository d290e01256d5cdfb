#pragma once

namespace truth {

/// What is recorded of a motion.
enum class Camera { bending_angle, joint_angles };

}  // namespace truth
