#pragma once

#include <Eigen/Core>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// Pose of the second body seen from the first, which sits at the origin with its axis along +z.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of the second body, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     ///< its axis; finite, not zero, any length (it is normalised)
  /// Direction of the x axis, for bodies without rotational symmetry; only its part across `axis` counts. If that part
  /// is zero, +y replaces it.
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();
};

/// The body's axes as columns. The matrix takes a vector from the body's axes to those of its pose.
[[nodiscard]] Eigen::Matrix3d rotation_of(const Pose& pose);

/// A pose as the body at `first` sees it: position and directions in the axes of that body. Both arguments are in the
/// same axes. If `first` is the origin with its axes, the pose keeps its bits.
[[nodiscard]] Pose seen_from(const Pose& first, const Pose& pose);

/// Force and torque on the second body.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< N m, about the centre of the second body
};

/// Exact force and torque on the second body in any pose, displaced and tilted, also with the magnet partly or wholly
/// in the bore. Positive current and positive remanence give moments along each body's +axis. The error is below 1e-7
/// of the force (for the torque, of force times the second body's size) if the clearance is at least about 3 % of the
/// larger body's size; nearer it grows, mostly to below 1e-5.
///
/// For bodies that overlap (copper in magnet) the result is that of the two current distributions in the same place,
/// finite, slow (milliseconds) and good to about 0.5 %. It serves a solver that steps past touching and no design.
/// Theory and sources: docs/theory/magnetics.md. Throws std::invalid_argument if a current or a pose is not finite or
/// the axis is zero.
[[nodiscard]] Wrench wrench(const ThickCoil& coil, double current, const CylinderMagnet& magnet, const Pose& pose);
/// Force and torque between two magnets, with the same conventions.
[[nodiscard]] Wrench wrench(const CylinderMagnet& first, const CylinderMagnet& second, const Pose& pose);
/// Force and torque between two coils, with the same conventions.
[[nodiscard]] Wrench wrench(const ThickCoil& first, double first_current, const ThickCoil& second,
                            double second_current, const Pose& pose);

}  // namespace coilwright::magnetics
