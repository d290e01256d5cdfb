#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coilwright/magnetics/body.hpp"

namespace coilwright::exports {

/// A rectangle in space, divided into equal cells.
struct MapPlane {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< point with both coordinates 0, m
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();  ///< a unit vector
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();     ///< a unit vector across `right`
  std::string right_name = "x";                      ///< of the coordinate along `right`
  std::string up_name = "z";
  double left{};          ///< m; lowest coordinate along `right`
  double bottom{};        ///< m; lowest along `up`
  double cell{};          ///< m, side of a cell; > 0
  std::size_t columns{};  ///< >= 1
  std::size_t rows{};     ///< >= 1

  /// The point with these coordinates in the plane, m.
  [[nodiscard]] Eigen::Vector3d at(double along_right, double along_up) const {
    return origin + along_right * right + along_up * up;
  }
  /// The centres of the cells, row by row from the bottom, each row from the left.
  [[nodiscard]] std::vector<Eigen::Vector3d> points() const;
};

/// Draws a field in a plane as SVG, on A4 landscape: colour for the magnitude on a logarithmic scale of three decades,
/// arrows for the part in the plane, and the bodies where the plane cuts them. `flux_density` has a value in T for each
/// of points(); a value that is not finite, as in a plate of iron, leaves its cell grey. Throws std::invalid_argument
/// for another number of values.
[[nodiscard]] std::string field_map_svg(const MapPlane& plane, std::span<const Eigen::Vector3d> flux_density,
                                        std::span<const magnetics::Body> bodies, const std::string& title);

}  // namespace coilwright::exports
