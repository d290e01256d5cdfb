#pragma once

#include <Eigen/Core>
#include <array>

#include "coilwright/video/picture.hpp"

namespace coilwright::video {

/// The model of a camera: a pinhole with the distortion of Brown and Conrady, as in OpenCV's documentation of calib3d.
struct Lens {
  int width{};                         ///< of its pictures, px
  int height{};                        ///< of its pictures, px
  Eigen::Vector2d focal{};             ///< focal lengths over the pixel's width and height; > 0
  Place centre{};                      ///< place of the optical axis
  std::array<double, 5> distortion{};  ///< k1, k2, p1, p2, k3
};

/// A lens without distortion that sees `view`, rad, over the longer side of pictures of this size.
[[nodiscard]] Lens plain_lens(int width, int height, double view);

/// A lens with a phone's usual angle of view, 65 degrees, for films without a calibrated lens.
[[nodiscard]] Lens usual_lens(int width, int height);

/// The direction (x, y, 1) of the ray that the lens draws at `place`.
[[nodiscard]] Eigen::Vector2d undistorted(const Lens& lens, const Place& place);

/// The derivative of undistorted() with respect to the place, 1/px.
[[nodiscard]] Eigen::Matrix2d undistortion_slope(const Lens& lens, const Place& place);

}  // namespace coilwright::video
