#include "sizing/surrogate/surrogate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coilwright::sizing {
namespace {

Eigen::MatrixXd nodes(Eigen::Index count, Eigen::Index dimension) {
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> uniform{0.2, 0.9};
  return Eigen::MatrixXd::NullaryExpr(count, dimension, [&] { return uniform(random); });
}

// 3 + x - 2 y z + 4 x^2 - z^2
double quadratic(const Eigen::VectorXd& x) {
  return 3 + x[0] - 2 * x[1] * x[2] + 4 * x[0] * x[0] - x[2] * x[2];
}

double wavy(const Eigen::VectorXd& x) {
  return std::sin(3 * x[0]) * std::exp(-x[1]) + x[2];
}

Surrogate fitted(Eigen::Index count) {
  const Eigen::MatrixXd at = nodes(count, 3);
  Eigen::MatrixXd values(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    values(i, 0) = quadratic(at.row(i).transpose());
    values(i, 1) = wavy(at.row(i).transpose());
  }
  return Surrogate{at, values};
}

TEST(Surrogate, ReproducesAQuadraticOnceTheNodesDetermineIt) {
  const Surrogate model = fitted(30);
  const Eigen::Vector3d x{0.37, 0.61, 0.48};
  // nugget 1e-11 of the kernel over a condition of about 1e3 for 30 scattered nodes, values of order 4
  EXPECT_NEAR(model.values(x)[0], quadratic(x), 1e-5);
}

TEST(Surrogate, ComesCloserToASmoothFunctionWithMoreNodes) {
  const Eigen::Vector3d x{0.37, 0.61, 0.48};
  const double coarse = std::abs(fitted(12).values(x)[1] - wavy(x));
  const double middle = std::abs(fitted(40).values(x)[1] - wavy(x));
  const double fine = std::abs(fitted(120).values(x)[1] - wavy(x));
  EXPECT_LT(middle, coarse);
  EXPECT_LT(fine, 2e-3);
}

TEST(Surrogate, GoesThroughItsNodes) {
  const Eigen::MatrixXd at = nodes(40, 3);
  const Surrogate model = fitted(40);
  for (Eigen::Index i = 0; i < at.rows(); ++i) {
    EXPECT_NEAR(model.values(at.row(i).transpose())[1], wavy(at.row(i).transpose()), 1e-6);  // the nugget's bound
  }
}

TEST(Surrogate, HasTheSlopesOfItsValues) {
  const Surrogate model = fitted(40);
  const Eigen::Vector3d x{0.33, 0.72, 0.55};
  const Linearisation linearisation = model.linearised(x);
  EXPECT_NEAR((linearisation.values - model.values(x)).norm(), 0, 1e-12);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    step[axis] = 1e-5;  // truncation 1e-10; rounding of weights of order 1e4 over the step: 1e-7
    const Eigen::VectorXd difference = (model.values(x + step) - model.values(x - step)) / 2e-5;
    EXPECT_NEAR((difference - linearisation.jacobian.col(axis)).norm(), 0, 2e-6);
  }
}

TEST(Surrogate, StandsNodesThatCoincideOrShareACoordinate) {
  Eigen::MatrixXd at = nodes(12, 3);
  at.col(1).setConstant(0.4);
  at.row(5) = at.row(6);
  Eigen::MatrixXd values(12, 1);
  for (Eigen::Index i = 0; i < 12; ++i) values(i, 0) = quadratic(at.row(i).transpose());
  const Surrogate model{at, values};
  const Linearisation result = model.linearised(Eigen::Vector3d{0.5, 0.45, 0.6});
  EXPECT_TRUE(result.values.allFinite());
  EXPECT_TRUE(result.jacobian.allFinite());
}

}  // namespace
}  // namespace coilwright::sizing
