#include "coilwright/algebra/least_squares.hpp"

#include <gtest/gtest.h>

namespace coilwright::algebra {
namespace {

// The line through (0, 1), (1, 3), (2, 4), (3, 4): slope 1, intercept 1.5 (sums 6, 14 and 12, 23 by hand).
TEST(LeastSquares, IsTheLineOfTheNormalEquations) {
  Eigen::MatrixXd columns(4, 2);
  columns << 1, 0, 1, 1, 1, 2, 1, 3;
  const Eigen::VectorXd line = least_squares(columns, Eigen::Vector4d(1.0, 3.0, 4.0, 4.0));
  EXPECT_NEAR(line[0], 1.5, 1e-14);
  EXPECT_NEAR(line[1], 1.0, 1e-14);
}

TEST(LeastSquares, OrthonormalColumnsSpanTheFirstOnesInTurn) {
  Eigen::MatrixXd columns(4, 3);
  columns << 1, 0, 0, 1, 1, 1, 1, 2, 4, 1, 3, 9;
  const Eigen::MatrixXd basis = orthonormal(columns);
  EXPECT_LT((basis.transpose() * basis - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
  for (Eigen::Index count = 1; count <= 3; ++count) {
    const Eigen::MatrixXd first = basis.leftCols(count);
    const Eigen::VectorXd column = columns.col(count - 1);
    EXPECT_LT((column - first * (first.transpose() * column)).norm(), 1e-13) << count;
  }
}

}  // namespace
}  // namespace coilwright::algebra
