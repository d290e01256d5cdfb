#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "coilwright/magnetics/forces.hpp"

namespace coilwright::magnetics {
namespace {

Body recoiling_block(const Eigen::Vector3d& size, const Eigen::Vector3d& remanence, const Pose& pose = {}) {
  return {.part = Magnet{.shape = Cuboid{.size = size}, .remanence = remanence, .recoil_permeability = 1.05},
          .pose = pose};
}

Forces between(const Body& first, const Body& second) {
  return forces(std::vector<Body>{first, second});
}

// Not parallel to the last digit, so that the charges of the faces are integrated: another route to the same force.
Body nearly_parallel(Body body) {
  body.pose.axis += 1e-11 * Eigen::Vector3d(0.3, -0.5, 0.7);
  return body;
}

// Any magnetisations and sizes, side by side along any axis, one block's edges along any of the other's, before it or
// beyond its rim.
TEST(ParallelCuboids, ActAsTheChargesOfTheirFaces) {
  std::mt19937 random(17);
  const auto drawn = [&](double low, double high) {
    const auto one = [&] { return std::uniform_real_distribution<>(low, high)(random); };
    return Eigen::Vector3d(one(), one(), one());
  };
  const Pose upright;
  const Pose turned{.axis = {1.0, 0.0, 0.0}, .x_axis = {0.0, 0.0, -1.0}};
  const Pose reversed{.axis = {0.0, -1.0, 0.0}};
  for (int i = 0; i < 24; ++i) {
    const Body first = recoiling_block(drawn(2e-3, 10e-3), drawn(-1.0, 1.0),
                                       {.position = drawn(-1e-3, 1e-3), .axis = {0.0, 0.0, -1.0}});
    Pose pose = i % 3 == 0 ? upright : i % 3 == 1 ? turned : reversed;
    pose.position = drawn(-8e-3, 8e-3);
    pose.position[(i / 3) % 3] = i % 2 == 0 ? 12e-3 : -12e-3;
    const Body second = recoiling_block(drawn(2e-3, 10e-3), drawn(-1.0, 1.0), pose);
    const Forces closed = between(first, second);
    const Forces faces = between(first, nearly_parallel(second));
    const double force = faces.on[1].force.norm();
    const double error = 4.0 * faces.error + closed.error + 1e-10 * force;
    EXPECT_LT((closed.on[1].force - faces.on[1].force).norm(), error) << i;
    EXPECT_LT((closed.on[1].torque - faces.on[1].torque).norm(), 9e-3 * error) << i;
    EXPECT_GT(closed.error, 0.0) << i;
    EXPECT_LT(closed.error, 1e-9 * force) << i;
  }
}

// Faces, edges and corners that touch are the limit of those that nearly do.
TEST(ParallelCuboids, HaveALimitWhereTheyTouch) {
  const Eigen::Vector3d size(8e-3, 8e-3, 8e-3);
  const Body first = recoiling_block(size, {0.3, 0.0, 1.2});
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(0.0, 0.0, 8e-3), Eigen::Vector3d(4e-3, 8e-3, 8e-3),
                                    Eigen::Vector3d(8e-3, 8e-3, 8e-3), Eigen::Vector3d(1e-3, 1e-3, -8e-3)}) {
    const auto wrench_at = [&](const Eigen::Vector3d& position) {
      return between(first, recoiling_block(size, {0.0, 0.5, 1.0}, {.position = position})).on[1];
    };
    const Wrench touching = wrench_at(at);
    const Wrench apart = wrench_at(at * (1.0 + 1e-9));
    EXPECT_LT((touching.force - apart.force).norm(), 1e-6 * apart.force.norm());
    EXPECT_LT((touching.torque - apart.torque).norm(), 1e-8 * apart.force.norm());
  }
}

// Where rounding takes digits of the closed form, the charges are integrated, too: no step between the two.
TEST(ParallelCuboids, GoOverIntoIntegratedOnesFarAway) {
  const Eigen::Vector3d size(4e-3, 5e-3, 6e-3);
  const Body first = recoiling_block(size, {0.2, 0.0, 1.0});
  for (double z = 7e-3; z < 0.1; z *= 1.2) {
    const Body second = recoiling_block(size, {0.0, 0.3, 1.0}, {.position = {1e-3, 2e-3, z}});
    const Forces closed = between(first, second);
    const Forces faces = between(first, nearly_parallel(second));
    EXPECT_LT((closed.on[1].force - faces.on[1].force).norm(), 1e-8 * faces.on[1].force.norm()) << z;
  }
}

}  // namespace
}  // namespace coilwright::magnetics
