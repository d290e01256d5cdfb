#include "coilwright/algebra/minimum_norm.hpp"

#include <gtest/gtest.h>

namespace coilwright::algebra {
namespace {

// Two numbers that only show as their sum: x + y = 6 shared alike, and a third on its own.
TEST(MinimumNorm, SharesWhatIsNotToldApart) {
  Eigen::MatrixXd matrix(3, 3);
  matrix << 2, 2, 0, 2, 2, 0, 0, 0, 5;
  const Eigen::Vector3d right(12.0, 12.0, 10.0);
  const Eigen::Vector3d shared(3.0, 3.0, 2.0);
  EXPECT_LT((minimum_norm(matrix, right) - shared).norm(), 1e-13);
  Eigen::MatrixXd both(3, 2);
  both << right, 2.0 * right;
  const Eigen::MatrixXd solved = minimum_norm_columns(matrix, both);
  EXPECT_LT((solved.col(0) - shared).norm(), 1e-13);
  EXPECT_LT((solved.col(1) - 2.0 * shared).norm(), 1e-13);
}

// What is below the threshold counts as not told, though rounding would let it pass.
TEST(MinimumNorm, LeavesWhatLiesBelowItsThreshold) {
  const Eigen::MatrixXd matrix = Eigen::Vector2d(1.0, 1e-8).asDiagonal();
  const Eigen::Vector2d right(1.0, 1.0);
  EXPECT_NEAR(minimum_norm(matrix, right)[1], 1e8, 1.0);
  EXPECT_EQ(minimum_norm(matrix, right, 1e-6)[1], 0.0);
  EXPECT_NEAR(minimum_norm(matrix, right, 1e-6)[0], 1.0, 1e-15);
}

// A fit in which nothing may move has no columns; records of nothing have no rows.
TEST(MinimumNorm, OfNothingIsNothing) {
  EXPECT_EQ(minimum_norm(Eigen::MatrixXd(0, 0), Eigen::VectorXd(0)).size(), 0);
  EXPECT_EQ(minimum_norm(Eigen::MatrixXd(3, 0), Eigen::VectorXd::Ones(3), 1e-6).size(), 0);
  EXPECT_EQ(minimum_norm(Eigen::MatrixXd(0, 2), Eigen::VectorXd(0)), Eigen::VectorXd::Zero(2));
  const Eigen::MatrixXd both = minimum_norm_columns(Eigen::MatrixXd(3, 0), Eigen::MatrixXd::Ones(3, 2));
  EXPECT_EQ(both.rows(), 0);
  EXPECT_EQ(both.cols(), 2);
}

}  // namespace
}  // namespace coilwright::algebra
