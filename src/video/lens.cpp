#include "coilwright/video/lens.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coilwright::video {
namespace {

// Where the lens draws a direction, before focal length and centre.
Eigen::Vector2d distorted(const Lens& lens, const Eigen::Vector2d& ray) {
  const auto [k1, k2, p1, p2, k3] = lens.distortion;
  const double x = ray.x();
  const double y = ray.y();
  const double r2 = ray.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

}  // namespace

Lens plain_lens(int width, int height, double view) {
  const double focal = 0.5 * std::max(width, height) / std::tan(0.5 * view);
  return {.width = width,
          .height = height,
          .focal = {focal, focal},
          .centre = {0.5 * (width - 1), 0.5 * (height - 1)},
          .distortion = {}};
}

Lens usual_lens(int width, int height) {
  return plain_lens(width, height, 65.0 * std::numbers::pi / 180.0);
}

Eigen::Vector2d undistorted(const Lens& lens, const Place& place) {
  const Eigen::Vector2d drawn = (place - lens.centre).cwiseQuotient(lens.focal);
  Eigen::Vector2d ray = drawn;
  constexpr int steps = 30;  // a fixed point, which contracts by the distortion: 0.3^30 < 1e-15
  for (int i = 0; i < steps; ++i) ray += drawn - distorted(lens, ray);
  return ray;
}

Eigen::Matrix2d undistortion_slope(const Lens& lens, const Place& place) {
  constexpr double step = 0.5;  // px: over a pixel no lens bends noticeably
  Eigen::Matrix2d out;
  for (int k = 0; k < 2; ++k) {
    const Place shift = step * Place::Unit(k);
    out.col(k) = (undistorted(lens, place + shift) - undistorted(lens, place - shift)) / (2.0 * step);
  }
  return out;
}

}  // namespace coilwright::video
