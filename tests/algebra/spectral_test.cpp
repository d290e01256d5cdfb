#include "coilwright/algebra/spectral.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coilwright::algebra {
namespace {

// The chain of three equal springs and masses between walls: 2 - sqrt 2, 2 and 2 + sqrt 2.
TEST(Spectral, ModesOfThreeMassesBetweenWalls) {
  Eigen::MatrixXd chain(3, 3);
  chain << 2, -1, 0, -1, 2, -1, 0, -1, 2;
  const SymmetricModes modes = symmetric_modes(chain);
  EXPECT_LT((modes.values - Eigen::Vector3d(2.0 - std::sqrt(2.0), 2.0, 2.0 + std::sqrt(2.0))).norm(), 1e-14);
  EXPECT_NEAR(std::abs(modes.vectors.col(1).dot(Eigen::Vector3d(1.0, 0.0, -1.0).normalized())), 1.0, 1e-14);
  const Eigen::MatrixXd again = modes.vectors * modes.values.asDiagonal() * modes.vectors.transpose();
  EXPECT_LT((again - chain).cwiseAbs().maxCoeff(), 1e-14);
}

// A rotation by any angle changes no length: the singular values are those of the diagonal.
TEST(Spectral, SingularValuesDoNotTurn) {
  Eigen::Matrix2d turn;
  turn << 0.6, -0.8, 0.8, 0.6;
  const Eigen::MatrixXd turned = turn * Eigen::Vector2d(-2.0, 5.0).asDiagonal() * turn;
  EXPECT_LT((singular_values(turned) - Eigen::Vector2d(5.0, 2.0)).norm(), 1e-14);
}

// The normal matrix of a fit without a number that may move.
TEST(Spectral, NothingHasNoModes) {
  const SymmetricModes modes = symmetric_modes(Eigen::MatrixXd(0, 0));
  EXPECT_EQ(modes.values.size(), 0);
  EXPECT_EQ(modes.vectors.size(), 0);
  EXPECT_EQ(singular_values(Eigen::MatrixXd(3, 0)).size(), 0);
}

}  // namespace
}  // namespace coilwright::algebra
