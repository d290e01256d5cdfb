#pragma once

#include <Eigen/Core>
#include <array>

#include "coilwright/video/picture.hpp"

namespace coilwright::video {

/// How a camera draws: a pinhole with the distortion of Brown and Conrady, as OpenCV's documentation of calib3d has it.
struct Lens {
  int width{};                         ///< of its pictures, px
  int height{};                        ///< of its pictures, px
  Eigen::Vector2d focal{};             ///< focal lengths over the pixel's width and height; > 0
  Place centre{};                      ///< where the optical axis passes
  std::array<double, 5> distortion{};  ///< k1, k2, p1, p2, k3
};

/// A lens that does not distort and sees `view`, rad, over the longer side of pictures of this size.
[[nodiscard]] Lens plain_lens(int width, int height, double view);

/// One of a phone's usual angle of view, 65 degrees: what is taken where none was calibrated.
[[nodiscard]] Lens usual_lens(int width, int height);

/// The direction (x, y, 1) of the ray that the lens draws at `place`.
[[nodiscard]] Eigen::Vector2d undistorted(const Lens& lens, const Place& place);

/// The derivative of undistorted() with respect to the place, 1/px.
[[nodiscard]] Eigen::Matrix2d undistortion_slope(const Lens& lens, const Place& place);

}  // namespace coilwright::video
