#include "coilwright/magnetics/overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace coilwright::magnetics {
namespace {

const Ring coil_ring{.inner_radius = 5e-3, .outer_radius = 9e-3, .length = 10e-3};
const Ring magnet_ring{.inner_radius = 0.0, .outer_radius = 4e-3, .length = 6e-3};

Pose pose_at(double x, double y, double z, const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  return {.position = {x, y, z}, .axis = axis};
}

// Whether a magnet is in the bore, touches the copper or is in it, along one axis: by its lengths alone.
TEST(Overlap, OfBodiesWithParallelAxesFollowsFromTheirLengths) {
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(0, 0, 0)));  // in the bore, 1 mm of play
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(0.9e-3, 0, 1e-3)));
  EXPECT_TRUE(overlap(coil_ring, magnet_ring, pose_at(1.1e-3, 0, 1e-3)));
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(0, 7e-3, 8e-3)));  // face on face
  EXPECT_TRUE(overlap(coil_ring, magnet_ring, pose_at(0, 7e-3, 7.9e-3)));
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(13.1e-3, 0, 0)));  // side by side
  EXPECT_TRUE(overlap(coil_ring, magnet_ring, pose_at(12.9e-3, 0, 0)));
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(9.3e-3, 9.3e-3, 0)));  // 13.15 mm apart
  EXPECT_TRUE(overlap(coil_ring, magnet_ring, pose_at(9.1e-3, 9.1e-3, 0)));   // 12.87 mm
  // A thin disc right through the winding, larger than the coil: none of the coil's ends is in it.
  const Ring disc{.inner_radius = 0.0, .outer_radius = 20e-3, .length = 1e-3};
  EXPECT_TRUE(overlap(coil_ring, disc, pose_at(0, 0, 1e-3)));
  EXPECT_FALSE(overlap(coil_ring, disc, pose_at(0, 0, 5.6e-3)));
  // Alike and in one place.
  for (const double z : {0.0, 1e-6}) {
    EXPECT_TRUE(overlap(coil_ring, coil_ring, pose_at(0, 0, z)));
    EXPECT_TRUE(overlap(magnet_ring, magnet_ring, pose_at(0, 0, z, -Eigen::Vector3d::UnitZ())));
  }
  // One in the other, whole.
  const Ring large{.inner_radius = 0.0, .outer_radius = 30e-3, .length = 50e-3};
  EXPECT_TRUE(overlap(coil_ring, large, pose_at(0, 0, 0)));
  EXPECT_TRUE(overlap(large, coil_ring, pose_at(0, 0, 0)));
}

TEST(Overlap, OfTiltedBodies) {
  const double tilt = std::numbers::pi / 2.0;
  const Eigen::Vector3d across(std::sin(tilt), 0.0, std::cos(tilt));
  // A magnet on its side above the face: its radius is 4 mm, half of the coil 5 mm.
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(7e-3, 0, 9.05e-3, across)));
  EXPECT_TRUE(overlap(coil_ring, magnet_ring, pose_at(7e-3, 0, 8.9e-3, across)));
  // In the bore on its side: 8 mm across and 6 mm long fit into 10 mm only by their diagonal.
  EXPECT_FALSE(overlap(coil_ring, magnet_ring, pose_at(0, 0, 0, across)));
  EXPECT_TRUE(
      overlap(coil_ring, Ring{.inner_radius = 0.0, .outer_radius = 4.5e-3, .length = 6e-3}, pose_at(0, 0, 0, across)));
}

// A second route: points drawn inside both bodies. Where some lie in both, they overlap; the other way round needs no
// such point, as the overlap may be small.
TEST(Overlap, IsSeenWhereARandomPointLiesInBoth) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int overlapping = 0;
  int apart = 0;
  for (int round = 0; round < 300; ++round) {
    const Eigen::Vector3d axis(unit(random), unit(random), unit(random) + 1.1);
    const Pose pose = pose_at(14e-3 * unit(random), 14e-3 * unit(random), 12e-3 * unit(random), axis);
    const bool found = overlap(coil_ring, magnet_ring, pose);
    const Eigen::Vector3d along = axis.normalized();
    bool both = false;
    for (int k = 0; k < 2000 && !both; ++k) {
      const Eigen::Vector3d point(9e-3 * unit(random), 9e-3 * unit(random), 5e-3 * unit(random));
      const double radius = std::hypot(point.x(), point.y());
      if (radius < 5e-3 || radius > 9e-3) continue;
      const Eigen::Vector3d from = point - pose.position;
      const double height = from.dot(along);
      both = std::abs(height) < 2.99e-3 && (from - height * along).norm() < 3.99e-3;
    }
    if (both) {
      EXPECT_TRUE(found) << round;
      ++overlapping;
    } else if (!found) {
      ++apart;
    }
  }
  EXPECT_GT(overlapping, 50);
  EXPECT_GT(apart, 50);
}

}  // namespace
}  // namespace coilwright::magnetics
