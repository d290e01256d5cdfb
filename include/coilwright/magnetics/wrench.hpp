#pragma once

#include <Eigen/Core>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// Where the second body is, seen from the first: the first sits at the origin with its axis along +z.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of the second body, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     ///< its axis; finite, not zero, any length (it is normalised)
  /// Its x axis, for bodies that are not alike all round; of it counts what is across `axis`. Where it has nothing
  /// across, +y stands in for it.
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();
};

/// The body's axes as columns: takes a vector from the body's axes to those that its pose is given in.
[[nodiscard]] Eigen::Matrix3d rotation_of(const Pose& pose);

/// A pose as the body at `first` sees it, both given in the same axes: position and directions in the axes of that
/// body. From the origin and along the axes a pose keeps its bits.
[[nodiscard]] Pose seen_from(const Pose& first, const Pose& pose);

/// Force and torque on the second body.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< N m, about the centre of the second body
};

/// Exact force and torque on the second body in any pose, displaced and tilted, the magnet partly or wholly in the
/// bore included. Positive current and positive remanence give moments along each body's +axis.
/// Error below 1e-7 of the force (of force times the second body's size for the torque) where the clearance is at
/// least about 3 % of the larger body's size; nearer it grows, mostly to below 1e-5. Bodies that overlap (copper in
/// magnet): the result is that of the two current distributions in the same place, finite, slow (milliseconds) and good
/// to about 0.5 %; it is there for a solver that steps past touching, not to design with. Theory and sources:
/// docs/theory/magnetics.md.
/// Throws std::invalid_argument when a current or a pose is not finite or the axis is zero.
[[nodiscard]] Wrench wrench(const ThickCoil& coil, double current, const CylinderMagnet& magnet, const Pose& pose);
/// The same for two magnets.
[[nodiscard]] Wrench wrench(const CylinderMagnet& first, const CylinderMagnet& second, const Pose& pose);
/// The same for two coils.
[[nodiscard]] Wrench wrench(const ThickCoil& first, double first_current, const ThickCoil& second,
                            double second_current, const Pose& pose);

}  // namespace coilwright::magnetics
