#pragma once

#include <Eigen/Core>
#include <variant>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// A full cylinder or, with an inner radius, a ring of rectangular section. Its axis is the body's z axis.
struct Ring {
  double inner_radius{};  ///< m; 0 for a full cylinder; finite, >= 0
  double outer_radius{};  ///< m; finite, > inner_radius
  double length{};        ///< m, along the axis; finite, > 0
};

/// A rectangular block with its edges along the body's axes.
struct Cuboid {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< m, along x, y and z; finite, > 0
};

using Shape = std::variant<Ring, Cuboid>;

/// A coil and its current. Its moment is along the body's z axis if the current is positive.
struct DrivenCoil {
  ThickCoil coil;
  double current{};  ///< A; finite
};

/// A permanent magnet, magnetised uniformly in any direction. With a recoil permeability above 1 its own field reduces
/// the magnetisation, here in the mean over the magnet and along each of its axes separately.
struct Magnet {
  Shape shape;
  Eigen::Vector3d remanence = Eigen::Vector3d::Zero();  ///< Br with its direction in the body's axes, T; finite
  double recoil_permeability = 1.0;                     ///< as that of a CylinderMagnet
};

[[nodiscard]] Magnet magnet_of(const CylinderMagnet& magnet);

/// A coil or a magnet with its pose, which makes a field and feels one.
struct Body {
  std::variant<DrivenCoil, Magnet> part;
  Pose pose{};  ///< of its centre and axes among all bodies
};

/// Throws std::invalid_argument naming the field, the rule and the value if a body breaks a rule above.
void check(const Body& body);

/// The space that a body fills.
[[nodiscard]] Shape shape_of(const Body& body);

/// Half of the extent of a shape along a direction (a unit vector in its own axes), m.
[[nodiscard]] double half_extent(const Shape& shape, const Eigen::Vector3d& direction);

/// Mean polarisation of a magnet in its own field, T: Br_i / (1 + chi N_i) along each axis, with the magnetometric
/// demagnetisation factors of its shape. Source: docs/theory/magnetics.md.
[[nodiscard]] Eigen::Vector3d polarisation_of(const Magnet& magnet);

/// Magnetometric demagnetisation factors of a shape along its three axes; they add up to 1. That of a block is by
/// Aharoni's formula (J. Appl. Phys. 83, 3432, 1998), that of a ring by those of two cylinders and the field of one in
/// the other.
[[nodiscard]] Eigen::Vector3d demagnetisation_factors(const Shape& shape);

}  // namespace coilwright::magnetics
