#include "sizing/problem/design_space.hpp"

#include <gtest/gtest.h>

namespace coilwright::sizing {
namespace {

std::vector<Variable> variables() {
  return {{.name = "layout", .kind = VariableKind::categorical, .lower = 0, .upper = 2, .step = 0},
          {.name = "turns", .kind = VariableKind::integer, .lower = 3, .upper = 12, .step = 2},
          {.name = "fixed", .kind = VariableKind::continuous, .lower = 0.7, .upper = 0.7, .step = 0},
          {.name = "gap", .kind = VariableKind::continuous, .lower = 0.4, .upper = 2.9, .step = 0.25},
          {.name = "finish", .kind = VariableKind::categorical, .lower = 0, .upper = 1, .step = 0}};
}

TEST(DesignSpace, LeavesFixedVariablesOutAndCountsTheRest) {
  const DesignSpace space{variables()};
  EXPECT_EQ(space.dimension(), 2U);
  EXPECT_EQ(space.combinations(), 6U);
  EXPECT_EQ(space.design_count(), 3U * 5U * 11U * 2U);  // turns 3, 5, ..., 11: the grid does not meet 12
}

TEST(DesignSpace, SnapsToTheGridAndNeverBeyondIt) {
  const DesignSpace space{variables()};
  const std::vector<double> point = space.point(space.snapped(std::vector<double>{1.7, 0.33}), 5);
  EXPECT_EQ(point, (std::vector<double>{2, 11, 0.7, 0.4 + 3 * 0.25, 1}));
  EXPECT_EQ(space.point(space.unit(point), space.combination(point)), point);
  EXPECT_EQ(space.combination(point), 5U);
}

TEST(DesignSpace, HasNoCountWithoutAGridInEveryVariable) {
  std::vector<Variable> some = variables();
  some[3].step = 0;
  EXPECT_EQ(DesignSpace{some}.design_count(), 0U);
  EXPECT_EQ(DesignSpace(std::vector<Variable>(40, some[1])).design_count(), 0U);  // 5^40 does not fit
}

}  // namespace
}  // namespace coilwright::sizing
