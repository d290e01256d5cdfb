#include "coilwright/algebra/exponential.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coilwright::algebra {
namespace {

// x'' = -w^2 x + u over a time t in closed form: a rotation, however many turns it takes, about u / w^2.
TEST(HeldResponse, OfAnOscillatorIsItsRotation) {
  constexpr double w = 30.0;
  Eigen::MatrixXd oscillator(2, 2);
  oscillator << 0.0, 1.0, -w * w, 0.0;
  for (const double t : {1e-4, 0.002, 0.1, 2.0}) {
    const HeldResponse found = held_response(oscillator, t);
    Eigen::Matrix2d turned;
    turned << std::cos(w * t), std::sin(w * t) / w, -w * std::sin(w * t), std::cos(w * t);
    EXPECT_LT((found.transition - turned).cwiseAbs().maxCoeff(), 1e-11 * w) << t;
    const Eigen::Vector2d pushed((1.0 - std::cos(w * t)) / (w * w), std::sin(w * t) / w);
    EXPECT_LT((found.integral.col(1) - pushed).cwiseAbs().maxCoeff(), 1e-13 * w) << t;
  }
}

// A matrix without a full set of eigenvectors, and without an inverse: the series ends after its square.
TEST(HeldResponse, OfANilpotentMatrixIsItsSeries) {
  Eigen::MatrixXd jordan = Eigen::MatrixXd::Zero(3, 3);
  jordan(0, 1) = 2.0;
  jordan(1, 2) = 3.0;
  const HeldResponse found = held_response(jordan, 2.0);
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(3, 3);
  const Eigen::MatrixXd square = jordan * jordan;
  EXPECT_LT((found.transition - (identity + 2.0 * jordan + 2.0 * square)).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((found.integral - (2.0 * identity + 2.0 * jordan + 4.0 / 3.0 * square)).cwiseAbs().maxCoeff(), 1e-13);
}

// Stiff: what relaxes within a millionth of the time has come to its end.
TEST(HeldResponse, OfAStiffMatrixIsWhereItRelaxesTo) {
  Eigen::MatrixXd stiff(2, 2);
  stiff << -1e6, 0.0, 1e6, -1e6;
  const HeldResponse found = held_response(stiff, 1.0);
  EXPECT_LT(found.transition.cwiseAbs().maxCoeff(), 1e-12);
  Eigen::MatrixXd end(2, 2);  // minus the inverse
  end << 1e-6, 0.0, 1e-6, 1e-6;
  EXPECT_LT((found.integral - end).cwiseAbs().maxCoeff(), 1e-12 * end.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace coilwright::algebra
