#pragma once

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// A coil and a magnet on the two sides of a joint. At angle 0 they are coaxial; the joint's axis is perpendicular to
/// that common axis and axis_offset away from it.
struct HingeGeometry {
  double coil_offset{};    ///< m, along the axis from the joint to the coil's centre (the paper's l_a); finite, >= 0
  double magnet_offset{};  ///< m, the same to the magnet's centre, on the other side (l_b); finite, >= 0, sum > 0
  double axis_offset{};    ///< m, from the joint to the common axis (h); finite, > 0
};

/// The method by which the torque of a hinge is computed.
enum class Fidelity {
  line_of_centres,  ///< the coaxial force at the distance of the centres, acting along the line through them: the
                    ///< source paper's (20)-(22) with (21) corrected; up to 18 % wrong at 82.5 degrees on its finger
  exact             ///< the whole force and torque of the tilted, displaced pair
};

/// Distance of the two centres at a joint angle (rad), m: the paper's (22).
[[nodiscard]] double centre_distance(const HingeGeometry& geometry, double angle);
/// Derivative of centre_distance() by the angle, m/rad: the arm of the line of centres about the joint.
[[nodiscard]] double centre_distance_derivative(const HingeGeometry& geometry, double angle);

/// Torque about the joint per ampere of coil current, N m/A. It is positive if it opens the joint (increases the
/// angle), as repulsion does: +1 A is the sense that repels the magnet, with the coil's moment opposite to the
/// magnet's. `angle` in rad. Throws std::invalid_argument naming the field if the geometry or the angle breaks its
/// rule.
[[nodiscard]] double hinge_torque_per_ampere(const ThickCoil& coil, const CylinderMagnet& magnet,
                                             const HingeGeometry& geometry, Fidelity fidelity, double angle);

}  // namespace coilwright::magnetics
