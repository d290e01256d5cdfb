#include "video/robust_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coilwright::video {
namespace {

struct Rows {
  explicit Rows(int count) : terms(count, 2), values(count), times(Eigen::VectorXd::LinSpaced(count, 0.0, 1.0)) {}
  Eigen::MatrixXd terms;
  Eigen::VectorXd values;
  Eigen::VectorXd times;
  [[nodiscard]] LastCoefficient slope() const { return robust_last_coefficient(terms, values, times); }
};

// One row in ten is off by a hundred standard deviations, all to one side: least squares alone would be off by 10 of
// them.
TEST(RobustLine, IsNotMovedByATenthOfTheRows) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 0.02);
  Rows rows(400);
  for (int i = 0; i < 400; ++i) {
    rows.terms.row(i) << 1.0, 0.01 * i;
    rows.values[i] = 0.7 - 1.3 * 0.01 * i + normal(random) + (i % 10 == 3 ? 2.0 : 0.0);
  }
  const LastCoefficient slope = rows.slope();
  // The standard deviation of the slope: 0.02 / sqrt(sum of squares about the mean) = 8.7e-4.
  EXPECT_NEAR(slope.value, -1.3, 4 * 8.7e-4);
}

// A column that is a wave, and errors of which each keeps a share of the one before. The plain standard deviation is
// that of a share of 0; at 0.9 errors are three times as large.
TEST(RobustLine, StatesWhatErrorsThatAreAlikeFromRowToRowDoToIt) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const double kept : {0.0, 0.9}) {
    double squares = 0.0;
    double stated = 0.0;
    constexpr int draws = 100;
    for (int draw = 0; draw < draws; ++draw) {
      Rows rows(400);
      double error = normal(random);
      for (int i = 0; i < 400; ++i) {
        error = kept * error + std::sqrt(1.0 - kept * kept) * normal(random);
        rows.terms.row(i) << 1.0, std::sin(0.1 * i);
        rows.values[i] = error;
      }
      const LastCoefficient slope = rows.slope();
      squares += slope.value * slope.value;
      stated += slope.sigma * slope.sigma;
    }
    // Each sum of a hundred squares is known to a seventh, those of a jackknife over four parts to a fifth.
    EXPECT_GT(stated, 0.6 * squares) << kept;
    EXPECT_LT(stated, 1.7 * squares) << kept;
  }
}

TEST(RobustLine, KnowsNoCoefficientOfAColumnThatIsNearlyTheOther) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.01);
  Rows rows(400);
  for (int i = 0; i < 400; ++i) {
    rows.terms.row(i) << 1.0, 1.0 + 1e-3 * normal(random);
    rows.values[i] = 0.5 + normal(random) + 0.02 * std::sin(0.05 * i);
  }
  const LastCoefficient slope = rows.slope();
  EXPECT_FALSE(std::abs(slope.value) > 5.0 * slope.sigma) << slope.value << " " << slope.sigma;
}

}  // namespace
}  // namespace coilwright::video
