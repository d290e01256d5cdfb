#include "coilwright/simulation/choice_effects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "coilwright/simulation/part_limits.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

std::vector<PartLimit> limits_of(const actuator::Design& design, const OperatingPoint& point) {
  const EvaluatedDesign evaluated = evaluate(design, point);
  return part_limits(evaluated.view());
}

const PartLimit& limit_of(const std::vector<PartLimit>& limits, std::string_view quantity) {
  return *std::ranges::find_if(limits, [&](const PartLimit& each) { return each.quantity.starts_with(quantity); });
}

// The paper's finger holds about 1.1 A for ever: a third less is kept, a third more burns a coil, and three times more
// has no steady temperature at all.
TEST(PartLimits, AreKeptBelowTheContinuousCurrentAndBrokenAbove) {
  const actuator::Design design = actuator::paper_finger();
  for (const PartLimit& limit : limits_of(design, {.current = 0.7})) {
    if (limit.conditional) continue;
    EXPECT_FALSE(limit.is_broken()) << limit.quantity;
    EXPECT_GT(limit.margin(), 0.0) << limit.quantity;
  }
  const std::vector<PartLimit> hot = limits_of(design, {.current = 1.35});
  EXPECT_TRUE(limit_of(hot, "coil_").is_broken());
  EXPECT_LT(limit_of(hot, "coil_").margin(), 0.0);
  const std::vector<PartLimit> runaway = limits_of(design, {.current = 3.3});
  EXPECT_FALSE(limit_of(runaway, "coil_").value);
  EXPECT_TRUE(limit_of(runaway, "coil_").is_broken());
  EXPECT_EQ(limit_of(runaway, "coil_").margin(), -1.0);
}

// In still air the magnets of the straight finger bear 0.575 A (docs/theory/thermal.md, "The film"), with the film of
// the paper's remark 0.958 A.
TEST(PartLimits, OfStillAirAreConditionalWhereTheFilmIsCalibrated) {
  actuator::Design design = actuator::paper_finger();
  EXPECT_FALSE(limit_of(limits_of(design, {.current = 0.55}), "thermal_load_still_air").is_broken());
  const std::vector<PartLimit> warm = limits_of(design, {.current = 0.6});
  EXPECT_TRUE(limit_of(warm, "thermal_load_still_air").is_broken());
  EXPECT_TRUE(limit_of(warm, "thermal_load_still_air").conditional);
  EXPECT_THAT(limit_of(warm, "thermal_load_still_air").consequence, ::testing::HasSubstr("(156 W/m2K are taken)"));
  design.choices.film = actuator::FilmChoice::still_air;
  for (const PartLimit& limit : limits_of(design, {.current = 0.6}))
    EXPECT_NE(limit.quantity, "thermal_load_still_air");
}

// Against a wall the joints are opened less, and the coils are nearer to the magnets: these bear 1.02 A there, and 1.1
// A where the finger bends freely. A study of the free finger alone must be told what the wall does.
TEST(PartLimits, OfTheOtherPoseAreConditionalWhereOnePoseCounts) {
  using actuator::HeldCases;
  const actuator::Design design = actuator::paper_finger();
  const std::vector<PartLimit> free = limits_of(design, {.current = 1.05, .cases = HeldCases::free});
  EXPECT_FALSE(limit_of(free, "magnet_temperature").is_broken());
  EXPECT_TRUE(limit_of(free, "thermal_load_gripping").is_broken());
  EXPECT_TRUE(limit_of(free, "thermal_load_gripping").conditional);
  EXPECT_NEAR(*limit_of(free, "thermal_load_gripping").value, 1.05 / 1.02, 0.01);
  const std::vector<PartLimit> gripping = limits_of(design, {.current = 1.05, .cases = HeldCases::gripping});
  EXPECT_TRUE(limit_of(gripping, "magnet_temperature").is_broken());
  EXPECT_FALSE(limit_of(gripping, "thermal_load_free").is_broken());
  for (const PartLimit& limit : limits_of(design, {.current = 1.05})) {
    EXPECT_NE(limit.quantity, "thermal_load_free");
    EXPECT_NE(limit.quantity, "thermal_load_gripping");
  }
}

// What overheats with the assumed film needs no word on still air.
TEST(PartLimits, ThatAreConditionalAreNotSaidOfAPartThatIsBeyondItsLimit) {
  const auto names = [](double current) {
    std::vector<std::string> out;
    const EvaluatedDesign evaluated = evaluate(actuator::paper_finger(), {.current = current});
    for (const PartLimit& limit : broken_part_limits(evaluated.view())) out.emplace_back(limit.quantity);
    return out;
  };
  EXPECT_THAT(names(0.7), ::testing::Contains("thermal_load_still_air"));
  EXPECT_THAT(names(1.35), ::testing::Contains("coil_hot_spot_degC"));
  EXPECT_THAT(names(1.35), ::testing::Not(::testing::Contains("thermal_load_still_air")));
}

TEST(PartLimits, MeasureTheirMarginOverTheLimit) {
  EXPECT_DOUBLE_EQ((PartLimit{.quantity = "q", .value = 120.0, .limit = 150.0}.margin()), 0.2);
  EXPECT_DOUBLE_EQ((PartLimit{.quantity = "q", .value = 0.3, .limit = 0.0, .at_most = false}.margin()), 0.3);
  EXPECT_TRUE((PartLimit{.quantity = "q", .value = -0.1, .limit = 0.0, .at_most = false}.is_broken()));
}

TEST(ChoiceEffects, EvaluateTheSamePartsUnderEachOtherChoice) {
  const actuator::Design design = actuator::paper_finger();
  const OperatingPoint point{.current = 0.9, .duty = 0.7};
  const std::vector<ChoiceEffect> effects = choice_effects(design, point);
  ASSERT_FALSE(effects.empty());
  std::set<std::string> names;
  for (const ChoiceEffect& effect : effects) {
    EXPECT_TRUE(names.insert(std::string(effect.choice.subject) + "/" + effect.choice.otherwise).second);
    EXPECT_NE(effect.choice.taken, effect.choice.otherwise);
    EXPECT_FALSE(effect.choice.settled_by.empty());
    const auto* other = std::get_if<EvaluatedDesign>(&effect.result);
    ASSERT_NE(other, nullptr) << effect.choice.subject;
    EXPECT_EQ(other->point.current, 0.9);
    EXPECT_EQ(other->point.duty, 0.7);
    // The parts are the same: what they weigh does not depend on how they are modelled.
    EXPECT_NEAR(other->performance.mass, evaluate(design, point).performance.mass, 1e-12);
  }
}

}  // namespace
}  // namespace coilwright::simulation
