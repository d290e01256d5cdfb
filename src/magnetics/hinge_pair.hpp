#pragma once

#include "coilwright/magnetics/hinge_torque.hpp"
#include "magnetics/coil_on_magnet.hpp"

namespace coilwright::magnetics {

/// A coil with 1 A and a magnet on both sides of a hinge, made once for many angles.
struct HingePair {
  CoilOnMagnet bodies;
  HingeGeometry geometry;

  /// As hinge_torque_per_ampere() of them, which is that of `accuracy_of_pose`.
  [[nodiscard]] double torque(Fidelity fidelity, double angle, const Accuracy& accuracy) const;
};

}  // namespace coilwright::magnetics
