#pragma once

#include <numbers>

namespace truth {

inline constexpr double mu0 = 4e-7 * std::numbers::pi;  ///< of vacuum, H/m

/// Mutual inductance of two coaxial loops of radii `a`, `b` at axial distance `s`, H (Maxwell, Treatise, art. 701). Not
/// for loops that touch.
[[nodiscard]] double mutual_inductance(double a, double b, double s);

/// Field of a loop of radius `a` in its own cylindrical coordinates, for 1 A about +z, T/A.
struct LoopField {
  double radial{};
  double axial{};
};
/// At distance `radius` from the axis and `height` above the plane (Smythe, Static and Dynamic Electricity, 7.10). Not
/// on the wire.
[[nodiscard]] LoopField loop_field(double a, double radius, double height);

/// Azimuthal vector potential of the same loop, T m/A.
[[nodiscard]] double loop_potential(double a, double radius, double height);

}  // namespace truth
