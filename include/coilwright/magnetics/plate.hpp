#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "coilwright/magnetics/body.hpp"

namespace coilwright::magnetics {

/// A flat plate of soft iron beside bodies, taken as a mirror: it adds to the field in front of it the field of the
/// bodies' images behind its face, (mu - 1) / (mu + 1) times as strong. This is exact for a plate so large that its
/// edges lie where there is little flux, and so thick that it does not saturate; PlateLoad states both sizes.
struct Plate {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of a point on the face that the bodies are in front of, m
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< normal of that face, towards the bodies; not zero, any length
  double thickness{};                                 ///< m; finite, > 0
  double relative_permeability = std::numeric_limits<double>::infinity();  ///< >= 1; of mild steel 500 and more
};

/// Throws std::invalid_argument naming the field, the rule and the value.
void check(const Plate& plate);

/// The image of a body: its position and axes turned half round the normal in the mirror image of its place. A moment
/// across the face keeps its sense and one along it is turned, so that either is attracted.
[[nodiscard]] Body image_of(const Body& body, const Plate& plate);

/// Distance from the face to the nearest point of a body in front of it, m; < 0 if some of the body is behind.
[[nodiscard]] double distance_from(const Plate& plate, const Body& body);

/// Flux density at which mild steel saturates, T. Low-carbon steel has 1.5 to 1.7 T at 1 to 5 kA/m and 2.0 to 2.1 T at
/// 30 kA/m.
inline constexpr double steel_saturation = 2.0;

/// The sizes that a plate needs for its mirror to hold.
struct PlateLoad {
  double flux_density{};     ///< T, the largest in the plate, spread evenly over its thickness
  double least_thickness{};  ///< thickness at which that is steel_saturation, m
  double reach{};            ///< m, from the foot of the bodies' centre; the part beyond has a hundredth of the pull
};

/// Computes the load of a plate. The flux that enters the face runs along the plate to where it leaves: per width it is
/// twice the integral over the depth below of the tangential field of the bodies without the plate. Its largest value
/// is found on a grid, to about 1 %. Source: docs/theory/magnetics.md, "Iron".
[[nodiscard]] PlateLoad plate_load(std::span<const Body> bodies, const Plate& plate);

}  // namespace coilwright::magnetics
