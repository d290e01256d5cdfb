#include "sizing/surrogate/expected_gain.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace coilwright::sizing {
namespace {

using Point = std::vector<double>;

// Two objectives along the first variable, both growing with the second, which must be at least 0.2: the front is the
// line y = 0.2. Nothing can be evaluated in the corner of large x and large y.
Problem strip() {
  return {.variables = {{.name = "x", .lower = 0, .upper = 1}, {.name = "y", .lower = 0, .upper = 1}},
          .objectives = {{.name = "f"}, {.name = "g"}},
          .constraints = {"y at least"},
          .evaluate = [](std::span<const double> x) {
            Evaluation evaluation{.objectives = {x[0] + x[1], 1 - x[0] + x[1]},
                                  .constraints = {0.2 - x[1]},
                                  .failure = {},
                                  .infeasibility = 0};
            if (x[0] > 0.8 && x[1] > 0.7) evaluation = {.failure = "corner", .infeasibility = 1};
            return evaluation;
          }};
}

Samples known(const std::vector<Point>& points) {
  const Problem problem = strip();
  Samples samples{problem, {0.0}};
  std::size_t number = 0;
  for (const Point& point : points)
    samples.add({.point = point, .evaluation = problem.evaluate(point), .number = ++number});
  return samples;
}

// A front from x = 0 to 0.4 and from 0.9 to 1, and designs around it.
std::vector<Point> grid_with_a_gap() {
  std::vector<Point> points;
  for (const double x : {0.0, 0.1, 0.2, 0.3, 0.4, 0.9, 1.0})
    for (const double y : {0.0, 0.1, 0.25, 0.5, 0.9}) points.push_back({x, y});
  return points;
}

TEST(ExpectedGain, IsLargestInTheGapOfTheFrontAndWithinTheLimits) {
  const Samples samples = known(grid_with_a_gap());
  const std::vector<Point> candidates{{0.65, 0.1}, {0.15, 0.24}, {0.65, 0.22}, {0.65, 0.6}};
  EXPECT_EQ(of_most_expected_gain(samples, candidates, 1), std::vector<std::size_t>{2});
}

// Once one of two twins is chosen the other has nothing left to gain.
TEST(ExpectedGain, OfASecondDesignReckonsWithTheFirst) {
  const Samples samples = known(grid_with_a_gap());
  const std::vector<Point> candidates{{0.65, 0.22}, {0.6501, 0.2201}, {0.05, 0.21}, {0.8, 0.22}};
  std::vector<std::size_t> chosen = of_most_expected_gain(samples, candidates, 2);
  ASSERT_EQ(chosen.size(), 2u);
  std::ranges::sort(chosen);
  EXPECT_EQ(chosen[1], 3u);
}

// Of designs that are all infeasible it is the one that most probably keeps the limit.
TEST(ExpectedGain, GoesTowardsTheLimitsWhileNothingIsFeasible) {
  const Samples samples = known({{0, 0}, {0.5, 0.05}, {1, 0.1}, {0.2, 0.12}, {0.7, 0.02}});
  const std::vector<Point> candidates{{0.5, 0.0}, {0.5, 0.15}, {0.4, 0.3}};
  EXPECT_EQ(of_most_expected_gain(samples, candidates, 1), std::vector<std::size_t>{2});
}

TEST(ExpectedGain, LeavesOutWhatIsNearestToAFailure) {
  const Samples samples = known(grid_with_a_gap());
  EXPECT_TRUE(of_most_expected_gain(samples, {{0.95, 0.89}}, 1).empty());
  EXPECT_TRUE(of_most_expected_gain(known({{1.0, 0.9}}), {{0.1, 0.2}}, 1).empty());  // nothing is evaluated
}

}  // namespace
}  // namespace coilwright::sizing
