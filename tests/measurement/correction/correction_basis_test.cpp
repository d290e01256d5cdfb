#include "measurement/correction/correction_basis.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::correction {
namespace {

using enum actuator::CorrectionVariable;

const CorrectionShape shape{.variables = {{angle, 7, 0.3}, {rate, 7, 0.3}}, .most_directions = 9};

// A motion about a circle of angle and rate: the corners of the table are never visited.
std::vector<JointSample> circle() {
  std::vector<JointSample> out;
  for (int i = 0; i < 500; ++i) {
    const double phase = 0.0127 * i;
    out.push_back({{0.3 + 0.3 * std::cos(phase), 6.0 * std::sin(phase), 0.0}});
  }
  return out;
}

TEST(CorrectionBasis, SpansWhatWasVisitedAndALittleMore) {
  const auto basis = correction_basis(shape, circle());
  ASSERT_TRUE(basis.has_value());
  EXPECT_LT(basis->axes[0].nodes.front(), 0.0);
  EXPECT_GT(basis->axes[0].nodes.front(), -0.03);
  EXPECT_GT(basis->axes[0].nodes.back(), 0.6);
  EXPECT_LT(basis->axes[0].nodes.back(), 0.63);
  // A rate's table is symmetric, with a node at rest.
  EXPECT_EQ(basis->axes[1].nodes[3], 0.0);
  EXPECT_NEAR(basis->axes[1].nodes[5], -basis->axes[1].nodes[1], 1e-12);
}

TEST(CorrectionBasis, HasNoTorqueAtNodesThatTheMotionNeverCameNear) {
  const auto basis = correction_basis(shape, circle());
  ASSERT_TRUE(basis.has_value());
  EXPECT_EQ(std::ranges::count(basis->visited, 0) > 0, true);
  for (Eigen::Index node = 0; node < basis->directions.rows(); ++node)
    if (basis->visited[static_cast<std::size_t>(node)] == 0) {
      EXPECT_EQ(basis->directions.row(node).norm(), 0.0) << node;
    }
}

// What the directions can follow is smooth: one that changes slowly over both variables, to a few per cent.
TEST(CorrectionBasis, FollowsASmoothTorqueWithAFewDirections) {
  const std::vector<JointSample> samples = circle();
  const auto basis = correction_basis({.variables = shape.variables, .most_directions = 16}, samples);
  ASSERT_TRUE(basis.has_value());
  EXPECT_LE(basis->size(), 16);
  Eigen::VectorXd wanted(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    wanted[static_cast<Eigen::Index>(i)] = 1e-3 * samples[i].values[0] * std::tanh(samples[i].values[1] / 3.0);
  Eigen::MatrixXd columns(wanted.size(), basis->size());
  for (int i = 0; i < basis->size(); ++i) {
    std::vector<double> one(static_cast<std::size_t>(basis->size()), 0.0);
    one[static_cast<std::size_t>(i)] = 1.0;
    columns.col(i) = torques_at(basis->correction(one, 1.0), samples);
  }
  const Eigen::VectorXd left =
      wanted - columns * (columns.transpose() * columns).ldlt().solve(columns.transpose() * wanted);
  EXPECT_LT(left.norm(), 0.05 * wanted.norm());
}

// Independent standard normal coefficients make torques of about the scale along the motion.
TEST(CorrectionBasis, HasTheSizeOfItsScale) {
  const std::vector<JointSample> samples = circle();
  const auto basis = correction_basis(shape, samples);
  ASSERT_TRUE(basis.has_value());
  Normal normal(7);
  double square = 0.0;
  constexpr int draws = 200;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<double> z;
    for (int i = 0; i < basis->size(); ++i) z.push_back(normal());
    square += torques_at(basis->correction(z, 2e-3), samples).squaredNorm() / static_cast<double>(samples.size());
  }
  // Nodes at the edge of what was visited lose a part; 200 draws of nine numbers scatter by 5 %.
  EXPECT_GT(std::sqrt(square / draws), 0.6 * 2e-3);
  EXPECT_LT(std::sqrt(square / draws), 1.3 * 2e-3);
}

TEST(CorrectionBasis, IsNoneOfAVariableThatNeverChanged) {
  EXPECT_FALSE(correction_basis({.variables = {{angle, 7, 0.3}, {current, 5, 0.3}}, .most_directions = 9}, circle()));
  EXPECT_FALSE(correction_basis(shape, {}));
}

}  // namespace
}  // namespace coilwright::measurement::correction
