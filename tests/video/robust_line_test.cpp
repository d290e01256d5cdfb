#include "video/robust_line.hpp"

#include <gtest/gtest.h>

#include <random>

namespace coilwright::video {
namespace {

// One row in ten is off by a hundred standard deviations, all to one side: least squares alone would be off by 10 of
// them.
TEST(RobustLine, IsNotMovedByATenthOfTheRows) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 0.02);
  constexpr int rows = 400;
  Eigen::MatrixXd terms(rows, 2);
  Eigen::VectorXd values(rows);
  for (int i = 0; i < rows; ++i) {
    terms.row(i) << 1.0, 0.01 * i;
    values[i] = 0.7 - 1.3 * 0.01 * i + normal(random) + (i % 10 == 3 ? 2.0 : 0.0);
  }
  const LastCoefficient slope = robust_last_coefficient(terms, values);
  // The plain standard deviation of the slope: 0.02 / sqrt(sum of squares about the mean) = 8.7e-4.
  EXPECT_NEAR(slope.value, -1.3, 4 * 8.7e-4);
  EXPECT_NEAR(slope.sigma, 8.7e-4, 3e-4);
}

}  // namespace
}  // namespace coilwright::video
