#include "coilwright/video/lens.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coilwright::video {
namespace {

const Lens lens{.width = 1280,
                .height = 720,
                .focal = {905.0, 907.0},
                .centre = {641.3, 352.8},
                .distortion = {-0.21, 0.06, 0.0011, -0.0007, 0.004}};

// Brown and Conrady as OpenCV's documentation writes it, term by term.
Place drawn(double x, double y) {
  const double r2 = x * x + y * y;
  const double radial = 1.0 - 0.21 * r2 + 0.06 * r2 * r2 + 0.004 * r2 * r2 * r2;
  const double xd = x * radial + 2.0 * 0.0011 * x * y - 0.0007 * (r2 + 2.0 * x * x);
  const double yd = y * radial + 0.0011 * (r2 + 2.0 * y * y) - 2.0 * 0.0007 * x * y;
  return {641.3 + 905.0 * xd, 352.8 + 907.0 * yd};
}

TEST(Lens, FindsTheRayThatItDraws) {
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.31, -0.17}, {-0.62, 0.33}}) {
    const Eigen::Vector2d ray = undistorted(lens, drawn(x, y));
    EXPECT_NEAR(ray.x(), x, 1e-12);
    EXPECT_NEAR(ray.y(), y, 1e-12);
  }
}

TEST(Lens, HasTheInverseOfTheDrawingAsItsSlope) {
  constexpr double x = 0.41;
  constexpr double y = -0.22;
  constexpr double step = 1e-6;
  Eigen::Matrix2d forward;
  forward.col(0) = (drawn(x + step, y) - drawn(x - step, y)) / (2.0 * step);
  forward.col(1) = (drawn(x, y + step) - drawn(x, y - step)) / (2.0 * step);
  const Eigen::Matrix2d product = undistortion_slope(lens, drawn(x, y)) * forward;
  // Differences over a pixel: their error is the third derivative's, of the order of (1/905)^2.
  EXPECT_LT((product - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff(), 3e-6);
}

TEST(Lens, OfAPhoneSeesSixtyFiveDegreesOverItsLongerSide) {
  const Lens usual = usual_lens(640, 480);
  EXPECT_NEAR(2.0 * std::atan(320.0 / usual.focal.x()) * 180.0 / M_PI, 65.0, 1e-9);
  EXPECT_EQ(undistorted(usual, {319.5, 239.5}).norm(), 0.0);
}

}  // namespace
}  // namespace coilwright::video
