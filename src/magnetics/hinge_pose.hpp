#pragma once

#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// Where the magnet of a hinge is in the coil's frame: the coil at the origin, +z its axis away from the joint, +x from
/// the axis towards the joint. So +y is the axis about which a negative turn opens the joint.
[[nodiscard]] Pose hinge_pose(const HingeGeometry& geometry, double angle);

/// Torque by which a wrench on the magnet, about its centre and in the coil's frame, opens the hinge where its currents
/// run against the coil's, N m. With the magnet's moment along its axis an ampere of the coil attracts, so both signs
/// turn: it is the torque about +y.
[[nodiscard]] double torque_about_hinge(const Wrench& on_magnet, const HingeGeometry& geometry, double angle);

}  // namespace coilwright::magnetics
