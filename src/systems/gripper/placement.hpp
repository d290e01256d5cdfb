#pragma once

#include <Eigen/Core>
#include <cmath>

#include "coilwright/mechanics/planar_chain.hpp"
#include "coilwright/systems/gripper/gripper.hpp"

namespace coilwright::systems::gripper {

/// From the frame of a finger's chain (its base joint, straight down, opening towards +x) to the gripper's.
struct Placement {
  Eigen::Vector2d base;    ///< of its base joint, m
  double sign{};           ///< +1: opens towards +x; -1: mirrored. Also that of a rotation: a torque turns with it
  Eigen::Matrix2d turned;  ///< rotation by the mounting angle, then the mirror

  [[nodiscard]] Eigen::Vector2d direction(const Eigen::Vector2d& of_chain) const { return turned * of_chain; }
  [[nodiscard]] Eigen::Vector2d point(const Eigen::Vector2d& of_chain) const { return base + turned * of_chain; }
  [[nodiscard]] mechanics::PointJacobian jacobian(const mechanics::PointJacobian& of_chain) const {
    return turned * of_chain;
  }
  [[nodiscard]] Eigen::Vector2d in_chain(const Eigen::Vector2d& point) const {
    return turned.transpose() * (point - base);
  }
};

/// Of the left finger (0) or the right one (1).
[[nodiscard]] inline Placement placement(const Mounting& mounting, int finger) {
  const double sign = finger == 0 ? 1.0 : -1.0;
  const double tilt = -mounting.angle;
  Eigen::Matrix2d rotation;
  rotation << std::cos(tilt), -std::sin(tilt), std::sin(tilt), std::cos(tilt);
  const Eigen::Vector2d mirror(sign, 1.0);
  return {.base = {-0.5 * sign * mounting.spacing, 0.0}, .sign = sign, .turned = mirror.asDiagonal() * rotation};
}

}  // namespace coilwright::systems::gripper
