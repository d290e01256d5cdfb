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
  // nugget 1e-11 of the kernel over a condition of about 1e3 for 30 scattered
  // nodes, values of order 4
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

// 60 nodes in 20 variables, where a quadratic has 231 coefficients, and a point
// as far outside as the nodes are wide. With equal weights for all coefficients
// the first was off by 0.9.
TEST(Surrogate, PutsTheTrendFirstWhereNodesDoNotDetermineAQuadratic) {
  const Eigen::MatrixXd at = nodes(60, 20);
  Eigen::MatrixXd values(60, 2);
  for (Eigen::Index i = 0; i < 60; ++i)
    values.row(i) << at(i, 0), at.row(i).sum() / 20 + 0.5 * std::pow(at(i, 1) - 0.5, 2);
  const Surrogate model{at, values};
  Eigen::VectorXd far = Eigen::VectorXd::Constant(20, 0.2);
  far[0] = 1.6;
  EXPECT_NEAR(model.values(far)[0], 1.6, 0.02);
  EXPECT_NEAR(model.values(far)[1], (1.6 + 19 * 0.2) / 20 + 0.045, 0.1);
}

// Along the first of 12 axes the function waves; along the others it is straight. Sixty nodes of 12 axes are few: the
// weight takes a third of the error off.
TEST(Surrogate, FollowsAWaveAlongAnAxisOfMoreWeight) {
  const Eigen::MatrixXd at = nodes(60, 12);
  Eigen::MatrixXd values(60, 1);
  const auto wave = [](const Eigen::VectorXd& x) { return std::sin(12 * x[0]) + x.tail(11).sum(); };
  for (Eigen::Index i = 0; i < 60; ++i) values(i, 0) = wave(at.row(i).transpose());
  std::vector<double> weights(12, 1.0);
  weights[0] = 60;
  const Surrogate even{at, values}, weighted{at, values, weights};
  double error_even = 0, error_weighted = 0;
  for (double x = 0.25; x < 0.85; x += 0.05) {
    Eigen::VectorXd here = Eigen::VectorXd::Constant(12, 0.5);
    here[0] = x;
    error_even += std::abs(even.values(here)[0] - wave(here));
    error_weighted += std::abs(weighted.values(here)[0] - wave(here));
  }
  EXPECT_LT(error_weighted, 0.75 * error_even);
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(12, 0.45);
  const Linearisation linearisation = weighted.linearised(x);
  for (Eigen::Index axis = 0; axis < 12; ++axis) {
    // Its values are good to 1e-10, so a shorter step would lose more to rounding than to its length.
    const Eigen::VectorXd step = 1e-4 * Eigen::VectorXd::Unit(12, axis);
    const double difference = (weighted.values(x + step)[0] - weighted.values(x - step)[0]) / 2e-4;
    EXPECT_NEAR(linearisation.jacobian(0, axis), difference, 5e-6 * (1 + std::abs(difference)));
  }
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
    step[axis] = 1e-5;  // truncation 1e-10; rounding of weights of order 1e4
                        // over the step: 1e-7
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
