#pragma once

#include <array>
#include <cstddef>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

/// A full cylinder, which may be magnetised along its axis.
struct CylinderSize {
  double radius{};  ///< m; finite, > 0
  double length{};  ///< m; finite, > 0
};

/// Magnetometric demagnetisation factor N of a cylinder magnetised uniformly along its axis, 0 to 1: the mean of its
/// own field H over its volume is -N M. N = 1 - Nagaoka's coefficient of the solenoid of its shape
/// (docs/theory/magnetics.md). Throws std::invalid_argument naming the field, the rule and the value.
[[nodiscard]] double demagnetisation_factor(const CylinderSize& size);

/// Share of its polarisation that a magnet of relative recoil permeability `recoil` (>= 1) keeps in its own field: J /
/// Br = 1 / (1 + (recoil - 1) N), 0 to 1.
[[nodiscard]] double recoil_factor(const CylinderSize& size, double recoil);

/// Number of points at which the worst of the inner field is searched: 8 radii k R / 8, k = 0 to 7, on the face at -z,
/// then 8 on the face at +z.
inline constexpr std::size_t face_points = 16;
using FaceValues = std::array<double, face_points>;

/// The axial field of one body in the volume of a coaxial cylinder, A/m, positive along +z.
struct AxialField {
  double mean{};       ///< over the volume
  FaceValues faces{};  ///< at the face_points
};

/// Field of a coil with `current` (A) at the origin, in a cylinder whose centre is `distance` (m, finite) along +z. The
/// bodies must not overlap. The relative error of the mean is below 1e-6 if the clearance is at least 3 % of the larger
/// radius. Throws std::invalid_argument for numbers that break their rules.
[[nodiscard]] AxialField axial_field(const ThickCoil& coil, double current, const CylinderSize& within,
                                     double distance);
/// Field H outside a magnet at the origin with its moment along +z, in the same kind of cylinder.
[[nodiscard]] AxialField axial_field(const CylinderMagnet& magnet, const CylinderSize& within, double distance);

/// Local demagnetisation factors on the faces of a cylinder, just inside: H = -N M there.
[[nodiscard]] FaceValues face_demagnetisation_factors(const CylinderSize& size);

}  // namespace coilwright::magnetics
