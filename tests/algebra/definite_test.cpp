#include "coilwright/algebra/definite.hpp"

#include <gtest/gtest.h>

namespace coilwright::algebra {
namespace {

// Hilbert's matrix of four rows, whose inverse is one of whole numbers (Choi, Am. Math. Mon. 90 (1983) 301).
Eigen::MatrixXd hilbert() {
  Eigen::MatrixXd out(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k) out(i, k) = 1.0 / (i + k + 1);
  return out;
}

TEST(Definite, InverseOfHilbertsMatrixIsOfWholeNumbers) {
  Eigen::MatrixXd inverse(4, 4);
  inverse << 16, -120, 240, -140, -120, 1200, -2700, 1680, 240, -2700, 6480, -4200, -140, 1680, -4200, 2800;
  EXPECT_LT((inverse_of_definite(hilbert()) - inverse).cwiseAbs().maxCoeff(), 1e-8);
  const Eigen::Vector4d right(1.0, -2.0, 0.0, 4.0);
  EXPECT_LT((solve_definite(hilbert(), right) - inverse * right).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace coilwright::algebra
