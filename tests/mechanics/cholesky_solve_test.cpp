#include "coilwright/mechanics/cholesky_solve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace coilwright::mechanics {
namespace {

// Against a decomposition that knows nothing of Cholesky's.
TEST(CholeskySolve, SolvesWhatTheFactorIsOf) {
  for (Eigen::Index n = 1; n <= 12; ++n) {
    Eigen::MatrixXd root = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) root(i, j) += 0.3 / (1.0 + static_cast<double>(i + 2 * j));
    const Eigen::MatrixXd matrix = root * root.transpose();
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
    const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
    Eigen::VectorXd half = right;
    solve_lower(factor.matrixLLT(), half);
    EXPECT_NEAR(half.squaredNorm(), right.dot(matrix.fullPivLu().solve(right)), 1e-12 * half.squaredNorm()) << n;
    solve_upper(factor.matrixLLT(), half);
    EXPECT_LT((half - matrix.fullPivLu().solve(right)).norm(), 1e-12 * half.norm()) << n;
  }
}

}  // namespace
}  // namespace coilwright::mechanics
