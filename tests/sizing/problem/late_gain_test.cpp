#include "coilwright/sizing/problem/late_gain.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace coilwright::sizing {
namespace {

// The objectives are the variables.
Problem identity(std::size_t objectives) {
  Problem problem;
  problem.evaluate = [](std::span<const double> x) {
    return Evaluation{
        .objectives = {x.begin(), x.end()}, .constraints = {0.5 - x[0]}, .failure = {}, .infeasibility = 0};
  };
  for (std::size_t i = 0; i < objectives; ++i) {
    problem.variables.push_back({.name = std::string(1, static_cast<char>('a' + i)),
                                 .kind = VariableKind::continuous,
                                 .lower = 0,
                                 .upper = 20});
    problem.objectives.push_back({.name = problem.variables.back().name, .sense = Sense::minimise});
  }
  problem.constraints = {"limit"};
  return problem;
}

Archive archive_of(std::size_t objectives, const std::vector<std::vector<double>>& designs) {
  Archive archive{identity(objectives)};
  for (const std::vector<double>& design : designs) {
    (void)archive.evaluate(design);
    archive.number(design);
  }
  return archive;
}

TEST(LateGain, IsTheChangeOfTheBestOfOneObjective) {
  // Four fifths of five designs are four: the best of them is 8, and then 6; 0.1 breaks the limit.
  const Archive archive = archive_of(1, {{12}, {8}, {9}, {0.1}, {6}, {3}});
  EXPECT_DOUBLE_EQ(late_gain(archive, 5).value(), 0.25);
  // Nor does what a search evaluated after it, around its answer, count for it.
  EXPECT_DOUBLE_EQ(late_gain(archive_of(1, {{12}, {8}, {9}, {10}, {11}, {3}}), 5).value(), 0.0);
}

TEST(LateGain, IsTheShareOfAFrontsHypervolume) {
  // Between (1, 3) and (3, 1), reference 1.1 of that range: the two ends dominate 0.11 + 0.11 - 0.01 of the unit square
  // and its rim, and (2, 2) adds a square of (0.6 - 0.1)^2.
  const Archive archive = archive_of(2, {{1, 3}, {3, 1}, {4, 4}, {5, 5}, {2, 2}});
  EXPECT_NEAR(late_gain(archive, 5).value(), 0.25 / (0.21 + 0.25), 1e-12);
}

TEST(LateGain, IsUnknownWhereNothingFeasibleWasFoundEarly) {
  EXPECT_FALSE(late_gain(archive_of(1, {{0.1}, {0.2}, {0.3}, {0.4}, {6}}), 5));
  EXPECT_FALSE(late_gain(archive_of(1, {}), 0));
}

}  // namespace
}  // namespace coilwright::sizing
