#include "coilwright/sizing/problem/problem.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sizing/expect_error.hpp"

namespace coilwright::sizing {
namespace {

using testing::expect_error;

Problem legal() {
  return {.variables = {{.name = "turns", .kind = VariableKind::integer, .lower = 3, .upper = 17, .step = 0},
                        {.name = "gap", .kind = VariableKind::continuous, .lower = 0.4, .upper = 2.9, .step = 0.25},
                        {.name = "layout", .kind = VariableKind::categorical, .lower = 0, .upper = 2, .step = 0}},
          .objectives = {{.name = "torque", .sense = Sense::maximise}},
          .constraints = {"heat"},
          .evaluate = [](std::span<const double> x) {
            return Evaluation{.objectives = {x[0]}, .constraints = {x[1] - 2}, .failure = {}, .infeasibility = 0};
          }};
}

template <typename Change>
void expect_rejected(Change&& change, const std::string& text) {
  Problem problem = legal();
  change(problem);
  expect_error<std::invalid_argument>([&] { validate_problem(problem); }, text);
}

TEST(Problem, IsAcceptedWhenEveryRuleHolds) {
  EXPECT_NO_THROW(validate_problem(legal()));
}

TEST(Problem, SaysWhichFieldBreaksWhichRule) {
  expect_rejected([](Problem& p) { p.variables.clear(); }, "variables: must name at least one; got none");
  expect_rejected([](Problem& p) { p.variables[1].name.clear(); }, "variables[1].name: must not be empty; got \"\"");
  expect_rejected([](Problem& p) { p.variables[2].name = "turns"; },
                  "variables[2].name: must be unique; got \"turns\" twice");
  expect_rejected([](Problem& p) { p.variables[0].lower = NAN; }, "variables[0].lower: must be finite; got nan");
  expect_rejected([](Problem& p) { p.variables[0].upper = INFINITY; }, "variables[0].upper: must be finite; got inf");
  expect_rejected([](Problem& p) { p.variables[1].upper = 0.3; },
                  "variables[1].upper: must be >= lower (0.4); got 0.3");
  expect_rejected([](Problem& p) { p.variables[1].step = -0.5; },
                  "variables[1].step: must be finite and >= 0; got -0.5");
  expect_rejected([](Problem& p) { p.variables[1].step = 4; },
                  "variables[1].step: must not exceed the range 2.5; got 4");
  expect_rejected([](Problem& p) { p.variables[0].lower = 3.5; }, "variables[0].lower: must be whole; got 3.5");
  expect_rejected([](Problem& p) { p.variables[0].upper = 16.5; }, "variables[0].upper: must be whole; got 16.5");
  expect_rejected([](Problem& p) { p.variables[0].step = 1.5; }, "variables[0].step: must be whole; got 1.5");
  expect_rejected([](Problem& p) { p.variables[2].lower = 1; },
                  "variables[2].lower: must be 0 for a categorical; got 1");
  expect_rejected([](Problem& p) { p.variables[2].step = 2; },
                  "variables[2].step: must be 0 or 1 for a categorical; got 2");
  expect_rejected([](Problem& p) { p.objectives.clear(); }, "objectives: must name at least one; got none");
  expect_rejected([](Problem& p) { p.objectives[0].name.clear(); }, "objectives[0].name: must not be empty; got \"\"");
  expect_rejected([](Problem& p) { p.constraints.push_back("heat"); },
                  "constraints[1].name: must be unique; got \"heat\" twice");
  expect_rejected([](Problem& p) { p.evaluate = nullptr; }, "evaluate: must be callable; got an empty function");
}

TEST(Problem, TurnsANumberThatIsNotFiniteIntoAFailureWithItsName) {
  Problem problem = legal();
  problem.evaluate = [](std::span<const double> x) {
    return Evaluation{.objectives = {x[0] > 5 ? NAN : 1.5},
                      .constraints = {x[1] > 1 ? INFINITY : -0.5},
                      .failure = {},
                      .infeasibility = 0};
  };
  const Evaluation objective = evaluate_checked(problem, std::vector<double>{7, 0.65, 1});
  EXPECT_EQ(objective.failure, "objective 'torque' is not finite (nan)");
  EXPECT_TRUE(objective.objectives.empty());
  const Evaluation constraint = evaluate_checked(problem, std::vector<double>{4, 1.4, 1});
  EXPECT_EQ(constraint.failure, "constraint 'heat' is not finite (inf)");
  EXPECT_GT(constraint.infeasibility, 0);
  EXPECT_FALSE(is_feasible(constraint));
}

TEST(Problem, KeepsAFailuresReasonAndMakesItsDistanceFinite) {
  Problem problem = legal();
  problem.evaluate = [](std::span<const double>) {
    return Evaluation{.objectives = {3.5}, .constraints = {}, .failure = "does not fit", .infeasibility = NAN};
  };
  const Evaluation evaluation = evaluate_checked(problem, std::vector<double>{7, 0.65, 1});
  EXPECT_EQ(evaluation.failure, "does not fit");
  EXPECT_TRUE(evaluation.objectives.empty());
  EXPECT_EQ(evaluation.infeasibility, 1.0);
}

TEST(Problem, RejectsAnEvaluationWithAnotherNumberOfValues) {
  Problem problem = legal();
  problem.evaluate = [](std::span<const double>) {
    return Evaluation{.objectives = {1.5, 2.5}, .constraints = {-1}, .failure = {}, .infeasibility = 0};
  };
  const std::vector<double> point{7, 0.65, 1};
  expect_error<std::logic_error>([&] { (void)evaluate_checked(problem, point); },
                                 "evaluate: must return 1 objectives; got 2");
  problem.evaluate = [](std::span<const double>) {
    return Evaluation{.objectives = {1.5}, .constraints = {}, .failure = {}, .infeasibility = 0};
  };
  expect_error<std::logic_error>([&] { (void)evaluate_checked(problem, point); },
                                 "evaluate: must return 1 constraints; got 0");
}

TEST(Violation, SumsWhatIsAboveZeroOnly) {
  const Evaluation evaluation{.objectives = {2.5}, .constraints = {-0.5, 0.25, 1.5}, .failure = {}, .infeasibility = 0};
  EXPECT_DOUBLE_EQ(violation(evaluation), 1.75);
  EXPECT_FALSE(is_feasible(evaluation));
}

}  // namespace
}  // namespace coilwright::sizing
