#include "sizing/study/base_current.hpp"

#include <gtest/gtest.h>

#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

// The more current the more of the objective, up to the limit of one of the parts at 0.55 A; `mass` is violated by as
// much at any current.
Evaluation at(double current, double mass) {
  return {.objectives = {current}, .constraints = {mass, current - 0.55}, .failure = {}, .infeasibility = 0};
}

double found(double mass) {
  const CurrentVariable variable{.range = Interval{.lower = 0.3, .upper = 1.5, .step = 0.05}};
  const StudyObjective objective{.quantity = testing::quantity("grasp_force_N"), .sense = Sense::maximise};
  return best_current(variable, objective, [&](double current) { return at(current, mass); });
}

TEST(BaseCurrent, IsTheBestThatKeepsEveryLimit) {
  EXPECT_DOUBLE_EQ(found(-1.0), 0.55);
}

TEST(BaseCurrent, IsTheBestWhereALimitIsBrokenAtAnyCurrent) {
  EXPECT_DOUBLE_EQ(found(7.1), 0.55);
}

}  // namespace
}  // namespace coilwright::sizing
