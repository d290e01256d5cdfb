#include "coilwright/algebra/smooth_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coilwright::algebra {
namespace {

std::vector<double> values_at(const SmoothCurve& curve, double time) {
  std::vector<double> out(curve.width());
  curve.at(time, out);
  return out;
}

TEST(SmoothCurve, IsExactForCubicsAtAnyTimes) {
  const auto cubic = [](double t) { return 1.0 - 2.0 * t + 3.0 * t * t - 0.5 * t * t * t; };
  const std::vector<double> times{0.0, 0.1, 0.15, 0.4, 0.5, 0.9, 1.0};
  std::vector<double> values;
  for (const double t : times) {
    values.push_back(cubic(t));
    values.push_back(-2.0 * cubic(t));
  }
  const SmoothCurve curve(times, values, 2);
  for (double t = -0.1; t < 1.1; t += 0.013) {
    const std::vector<double> found = values_at(curve, t);
    EXPECT_NEAR(found[0], cubic(t), 1e-13) << t;
    EXPECT_NEAR(found[1], -2.0 * cubic(t), 2e-13) << t;
  }
}

TEST(SmoothCurve, IsStraightThroughTwoRowsAndAParabolaThroughThree) {
  EXPECT_NEAR(values_at(SmoothCurve(std::vector{1.0, 3.0}, std::vector{5.0, 9.0}, 1), 1.5)[0], 6.0, 1e-14);
  EXPECT_NEAR(values_at(SmoothCurve(std::vector{0.0, 1.0, 3.0}, std::vector{0.0, 1.0, 9.0}, 1), 2.0)[0], 4.0, 1e-14);
}

// Of a sine, whose error falls with the fourth power of the distance of the rows.
TEST(SmoothCurve, FollowsASineToTheFourthOrder) {
  const auto largest_error = [](int rows) {
    std::vector<double> times, values;
    for (int k = 0; k <= rows; ++k) {
      times.push_back(static_cast<double>(k) / rows);
      values.push_back(std::sin(6.0 * times.back()));
    }
    const SmoothCurve curve(times, values, 1);
    double out = 0.0;
    for (double t = 0.2; t < 0.8; t += 0.00137)
      out = std::max(out, std::abs(values_at(curve, t)[0] - std::sin(6.0 * t)));
    return out;
  };
  EXPECT_LT(largest_error(80), 1e-7);
  EXPECT_NEAR(largest_error(40) / largest_error(80), 16.0, 2.0);
}

}  // namespace
}  // namespace coilwright::algebra
