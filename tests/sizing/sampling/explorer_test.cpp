#include "sizing/sampling/explorer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coilwright::sizing {
namespace {

Problem plain(std::size_t dimension) {
  Problem problem{.variables = {},
                  .objectives = {{.name = "f"}, {.name = "g"}},
                  .constraints = {},
                  .evaluate = [](std::span<const double> x) {
                    return Evaluation{.objectives = {x[0], 1 - x[0]}, .constraints = {}, .failure = {}};
                  }};
  for (std::size_t i = 0; i < dimension; ++i)
    problem.variables.push_back({.name = std::string("x").append(std::to_string(i)), .lower = 0, .upper = 1});
  return problem;
}

TEST(Explorer, ProbesOneCoordinateOfAParent) {
  const Problem problem = plain(6);
  Samples samples{problem, {}};
  const std::vector<double> parent(6, 0.25);
  (void)samples.add({.point = parent, .evaluation = problem.evaluate(parent)});
  Explorer explorer{samples.space(), 3};
  std::vector<int> count(6, 0);
  for (int repeat = 0; repeat < 600; ++repeat) {
    const auto probe = explorer.probe(samples, {0});
    ASSERT_TRUE(probe.has_value());
    for (std::size_t axis = 0; axis < 6; ++axis) EXPECT_EQ(probe->point.unit[axis] != 0.25, axis == probe->axis);
    ++count[probe->axis];
  }
  for (const int each : count) EXPECT_NEAR(each, 100, 50);  // five standard deviations
}

// After 20 probes of each axis of which only those of axis 2 came near the
// front: (21 / 22) / (21 / 22 + 5 / 22) = 0.81.
TEST(Explorer, ProbesPromisingCoordinatesMoreOften) {
  const Problem problem = plain(6);
  Samples samples{problem, {}};
  const std::vector<double> parent(6, 0.25);
  (void)samples.add({.point = parent, .evaluation = problem.evaluate(parent)});
  Explorer explorer{samples.space(), 3};
  for (int repeat = 0; repeat < 20; ++repeat)
    for (std::size_t axis = 0; axis < 6; ++axis) explorer.count_probe(axis, axis == 2);
  int promising = 0;
  for (int repeat = 0; repeat < 600; ++repeat) promising += explorer.probe(samples, {0})->axis == 2 ? 1 : 0;
  EXPECT_NEAR(promising, 600 * 21.0 / 26, 50);  // five standard deviations
}

// The front is the line f + g = 1 from (0.2, 0.8) to (0.6, 0.4): its range is
// 0.4 in both.
TEST(Samples, MeasureHowFarObjectivesLieBehindTheFront) {
  const Problem problem = plain(1);
  Samples samples{problem, {}};
  for (const double x : {0.2, 0.6}) (void)samples.add({.point = {x}, .evaluation = problem.evaluate(std::vector{x})});
  EXPECT_NEAR(samples.excess({0.24, 0.9}), 0.25, 1e-12);
  EXPECT_NEAR(samples.excess({0.2, 0.8}), 0.0, 1e-12);
  EXPECT_NEAR(samples.excess({0.16, 0.76}), -0.1, 1e-12);
}

}  // namespace
}  // namespace coilwright::sizing
