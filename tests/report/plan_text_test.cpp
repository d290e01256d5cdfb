#include "coilwright/report/diagnosis/plan_text.hpp"

#include <gmock/gmock.h>

#include <string>

namespace coilwright::report {
namespace {

using measurement::planning::ExperimentPlan;
using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of(const ExperimentPlan& plan) {
  return to_text(formats::PlanReport{.plan = plan, .experiment = "steps.json", .actuator = "finger.json"});
}

ExperimentPlan example() {
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
  ExperimentPlan plan{.samples = 1200};
  plan.effects = {{.effect = {.kind = effects.find("dry_friction"), .values = {0.0144e-3}}, .main = 0, .visible = true},
                  {.effect = {.kind = effects.find("off_axis_force"), .values = {}}, .visible = true},
                  {.effect = {.kind = effects.find("coil_coil_force"), .values = {}}, .remark = "changes too little"},
                  {.effect = {.kind = effects.find("force_gain"), .values = {0.854}}, .main = 0, .visible = true},
                  {.effect = {.kind = effects.find("driver_saturation"), .values = {1.35}}, .main = 0, .visible = true},
                  {.effect = {.kind = effects.find("added_mass"), .values = {1e-3}},
                   .main = 0,
                   .remark = "would not be found even at its physical bound"}};
  return plan;
}

TEST(PlanText, SaysHowStrongEachEffectMustBe) {
  EXPECT_THAT(text_of(example()),
              HasSubstr("What steps.json could show on finger.json: 1200 samples of its fit runs.\n"));
  EXPECT_THAT(
      text_of(example()),
      HasSubstr(
          "  dry_friction       torque 0.0144 Nmm\n"
          "  off_axis_force     shows as it is\n"
          "  coil_coil_force    never                      changes too little\n"
          "  force_gain         gain 0.854 (1 without it)\n"
          "  driver_saturation  current 1.35 A or less\n"
          "  added_mass         never                      would not be found even at its physical bound: mass 1 g\n"));
}

// No pair is inseparable where nothing shows: that is no success.
TEST(PlanText, DoesNotPraiseAnExperimentThatShowsNothing) {
  ExperimentPlan plan = example();
  for (auto& each : plan.effects) each.visible = false;
  EXPECT_THAT(text_of(plan), HasSubstr("No effect shows in this experiment, so that none can be told from another.\n"));
  EXPECT_THAT(text_of(plan), Not(HasSubstr("could be told from every other one")));
}

TEST(PlanText, SaysWhatNoiseCostsWhoseColourIsNotKnown) {
  ExperimentPlan plan = example();
  plan.overdispersion = 1.1;
  EXPECT_THAT(text_of(plan), Not(HasSubstr("not white")));
  plan.overdispersion = 12.0;
  EXPECT_THAT(text_of(plan), HasSubstr("effects must be 3.5 times as strong as in white noise of\nthat level, and the "
                                       "strengths above are. A still run would tell a diagnosis its colour.\n"));
}

TEST(PlanText, SaysHowMuchPairsDiffer) {
  ExperimentPlan plan = example();
  EXPECT_THAT(text_of(plan), HasSubstr("every effect that shows could be told from every other one.\n"));
  plan.pairs = {{.first = 0, .second = 5, .over_limit = 0.38}};
  EXPECT_THAT(text_of(plan), HasSubstr("five times as strong. The number is how much they differ, over what\n"
                                       "telling them apart takes; 1 would be enough:\n"
                                       "  dry_friction  added_mass  0.38\n"));
}

}  // namespace
}  // namespace coilwright::report
