#include "coilwright/sizing/search/sensitivity.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "coilwright/sizing/search/search.hpp"
#include "sizing/expect_error.hpp"

namespace coilwright::sizing {
namespace {

using testing::expect_error;

// Maximise 3 turns + 2 width with turns + 2 width <= 11.3 ("room", over 10) and turns <= 7 ("stock", over 10); a third
// constraint never matters. turns whole in [1, 9], width in [0.5, 6], layout adds 0 or -0.4.
Problem packing() {
  return {.variables = {{.name = "turns", .kind = VariableKind::integer, .lower = 1, .upper = 9, .step = 0},
                        {.name = "width", .kind = VariableKind::continuous, .lower = 0.5, .upper = 6, .step = 0},
                        {.name = "layout", .kind = VariableKind::categorical, .lower = 0, .upper = 1, .step = 0}},
          .objectives = {{.name = "force", .sense = Sense::maximise}},
          .constraints = {"room", "stock", "heat"},
          .evaluate = [](std::span<const double> x) {
            return Evaluation{.objectives = {3 * x[0] + 2 * x[1] - 0.4 * x[2]},
                              .constraints = {(x[0] + 2 * x[1] - 11.3) / 10, (x[0] - 7) / 10, -0.5 - 0.01 * x[0]},
                              .failure = {},
                              .infeasibility = 0};
          }};
}

const VariableStep& step_of(const Sensitivity& sensitivity, const std::string& variable, double to) {
  for (const VariableStep& step : sensitivity.steps) {
    if (step.variable == variable && std::abs(step.to - to) < 1e-9) return step;
  }
  throw std::out_of_range(variable);
}

// By hand: turns = 7 (stock), width = (11.3 - 7) / 2 = 2.15, force = 25.3.
TEST(Sensitivity, OfAPackingIsWhatItsLinearProgramSays) {
  const SearchResult result = search(packing(), {.max_evaluations = 300, .seed = 6});
  ASSERT_TRUE(result.feasible);
  EXPECT_EQ(result.best->point[0], 7);
  EXPECT_NEAR(result.best->point[1], 2.15, 1e-4);  // the models keep 1e-6 of a constraint's scale to spare
  const Sensitivity& sensitivity = result.sensitivity;
  ASSERT_EQ(sensitivity.binding.size(), 2U);
  EXPECT_EQ(sensitivity.binding[0].name, "room");
  EXPECT_TRUE(sensitivity.binding[0].at_limit);
  EXPECT_TRUE(sensitivity.binding[0].blocks_step);
  // room 5 % of its scale wider: 0.5 more, all into width: force + 0.5
  EXPECT_EQ(sensitivity.binding[0].relaxed_by, 0.05);
  EXPECT_NEAR(sensitivity.binding[0].objective_change.value(), 0.5, 1e-3);
  // stock up to 7.5 turns: still 7, nothing gained
  EXPECT_EQ(sensitivity.binding[1].name, "stock");
  EXPECT_NEAR(sensitivity.binding[1].objective_change.value(), 0.0, 1e-3);

  const VariableStep& more = step_of(sensitivity, "turns", 8);
  EXPECT_NEAR(more.objective_change.value(), 3, 1e-12);
  EXPECT_TRUE(more.improves);
  EXPECT_THAT(more.violates, ::testing::UnorderedElementsAre("room", "stock"));
  const VariableStep& fewer = step_of(sensitivity, "turns", 6);
  EXPECT_NEAR(fewer.objective_change.value(), -3, 1e-12);
  EXPECT_FALSE(fewer.improves);
  EXPECT_TRUE(fewer.violates.empty());
  const VariableStep& wider = step_of(sensitivity, "width", result.best->point[1] + 0.055);
  EXPECT_NEAR(wider.objective_change.value(), 0.11, 1e-9);
  EXPECT_EQ(wider.violates, (std::vector<std::string>{"room"}));
  EXPECT_NEAR(step_of(sensitivity, "layout", 1).objective_change.value(), -0.4, 1e-12);
}

TEST(Sensitivity, RejectsOptionsAndDesignsItCannotUse) {
  Archive archive{packing()};
  const std::vector<double> inside{5, 1.5, 0}, outside{9, 5, 0};
  const Record good{.point = inside, .evaluation = archive.evaluate(inside)};
  const Record bad{.point = outside, .evaluation = archive.evaluate(outside)};
  expect_error<std::invalid_argument>([&] { (void)analyse_sensitivity(archive, good, {.relative_step = 1.5}); },
                                      "relative_step: must be > 0 and <= 1; got 1.5");
  expect_error<std::invalid_argument>([&] { (void)analyse_sensitivity(archive, good, {.relaxation = 0}); },
                                      "relaxation: must be finite and > 0; got 0");
  expect_error<std::invalid_argument>([&] { (void)analyse_sensitivity(archive, bad, {}); },
                                      "best: must be feasible; got a violation of 0.97");
  expect_error<std::invalid_argument>(
      [&] {
        (void)analyse_sensitivity(archive, {.point = {4, 1.5, 0}, .evaluation = good.evaluation}, {});
      },
      "best: must be in the archive; got a design that was never evaluated");
}

}  // namespace
}  // namespace coilwright::sizing
