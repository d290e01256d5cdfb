#include "video/plane_view.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "video/sighting_series.hpp"

namespace coilwright::video {
namespace {

// Tags of a plane that is turned by 0.17 rad about (0.6, 0.8), at places over the picture, in all directions.
struct Tilted {
  std::vector<TagView> views;
  std::vector<double> turns;
};

Eigen::Vector2d projected(const Eigen::Matrix3d& turn, double x, double y) {
  const Eigen::Vector3d at = turn * Eigen::Vector3d(x, y, 0.0) + Eigen::Vector3d(0.0, 0.0, 120.0);
  return at.hnormalized();
}

Tilted tilted_tags() {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.17, Eigen::Vector3d(0.6, 0.8, 0.0)).toRotationMatrix();
  Tilted out;
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5 * i;
    const double x = 30.0 * std::sin(1.3 * i);
    const double y = 20.0 * std::cos(2.1 * i);
    constexpr double step = 1e-4;
    TagView view{.ray = projected(turn, x, y), .slope = {}};
    for (int k = 0; k < 2; ++k) {
      const double u = k == 0 ? std::cos(angle) : -std::sin(angle);
      const double v = k == 0 ? std::sin(angle) : std::cos(angle);
      view.slope.col(k) =
          (projected(turn, x + step * u, y + step * v) - projected(turn, x - step * u, y - step * v)) / (2.0 * step);
    }
    out.views.push_back(view);
    out.turns.push_back(angle);
  }
  return out;
}

TEST(PlaneView, FindsTheTiltOfThePlane) {
  const FittedPlane found = fit_plane(std::array{tilted_tags().views});
  EXPECT_NEAR(found.plane.tilt(), 0.17, 1e-6);
  EXPECT_FALSE(found.rival);
}

// A tag on the optical axis that only turns is seen alike from either side.
TEST(PlaneView, NamesTheOtherPlaneWhereTagsDoNotTell) {
  std::vector<TagView> views;
  for (TagView each : tilted_tags().views) {
    each.slope = Eigen::AngleAxisd(0.17, Eigen::Vector3d(0.6, 0.8, 0.0)).toRotationMatrix().topLeftCorner<2, 2>() *
                 Eigen::Rotation2Dd(static_cast<double>(views.size())).toRotationMatrix();
    each.ray.setZero();
    views.push_back(each);
  }
  const FittedPlane found = fit_plane(std::array{views});
  EXPECT_NEAR(found.plane.tilt(), 0.17, 1e-4);
  ASSERT_TRUE(found.rival);
  EXPECT_NEAR(found.rival->tilt(), 0.17, 1e-4);
}

TEST(PlaneView, GivesTurnsAsTheyAreInThePlane) {
  const Tilted tags = tilted_tags();
  const PlaneView plane = fit_plane(std::array{tags.views}).plane;
  const auto angle = [&](std::size_t i) { return std::arg(ComplexMap(plane.shape(tags.views[i])).alike); };
  const auto uncorrected = [&](std::size_t i) { return std::arg(ComplexMap(tags.views[i].slope).alike); };
  double largest = 0.0;
  for (std::size_t i = 1; i < tags.views.size(); ++i) {
    EXPECT_NEAR(std::remainder(angle(i) - angle(0) - tags.turns[i], 2.0 * M_PI), 0.0, 1e-6) << i;
    largest = std::max(largest, std::abs(std::remainder(uncorrected(i) - uncorrected(0) - tags.turns[i], 2.0 * M_PI)));
  }
  EXPECT_GT(largest, 0.02);  // more than a degree, without
}

}  // namespace
}  // namespace coilwright::video
