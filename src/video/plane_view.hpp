#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/video/lens.hpp"

namespace coilwright::video {

/// A tag as a lens sees it: the direction (x, y, 1) to its centre, and the derivative of that by the place on the tag.
struct TagView {
  Eigen::Vector2d ray{};
  Eigen::Matrix2d slope{};
};

[[nodiscard]] TagView view_of(const Lens& lens, const Place& centre, const Eigen::Matrix2d& shape);

/// Turns the camera onto the normal of a plane.
class PlaneView {
 public:
  /// `tilt`: rad, turns about the picture's x and y axes.
  explicit PlaneView(const Eigen::Vector2d& tilt);
  /// The shape of a tag of the plane as the turned camera sees it: a square is a square, to the plane's scale.
  [[nodiscard]] Eigen::Matrix2d shape(const TagView& view) const;
  [[nodiscard]] double tilt() const noexcept { return tilt_; }  ///< rad

 private:
  double tilt_;
  Eigen::Matrix3d turn_;
};

/// A plane as views of tags show it.
struct FittedPlane {
  PlaneView plane;
  /// The plane that leans the other way, where the views do not tell the two apart.
  std::optional<PlaneView> rival{};
};

/// The plane in which all tags are squares, as well as they can be, by least squares. Of the two that lean by as much
/// to either side, the one in which each tag keeps its size wherever it is. `tags`: the views of each.
[[nodiscard]] FittedPlane fit_plane(std::span<const std::vector<TagView>> tags);

}  // namespace coilwright::video
