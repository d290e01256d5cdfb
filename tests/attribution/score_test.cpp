#include "attribution/score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "attribution/made_diagnosis.hpp"

namespace attribution {
namespace {

using coilwright::measurement::Diagnosis;
using coilwright::measurement::Verdict;

const Case asked{.number = 0, .category = Category::one, .request = {}};

TEST(Score, FindsOneThatIsReportedFirst) {
  const Outcome right = outcome_of(Category::one, {"drag"}, diagnosed(Verdict::explained, {"drag"}));
  EXPECT_TRUE(right.found);
  EXPECT_TRUE(right.alone);
  const Outcome second = outcome_of(Category::one, {"drag"}, diagnosed(Verdict::explained, {"creep", "drag"}));
  EXPECT_FALSE(second.found);
  EXPECT_FALSE(second.alone);
  const Outcome besides = outcome_of(Category::one, {"drag"}, diagnosed(Verdict::explained, {"drag", "creep"}));
  EXPECT_TRUE(besides.found);
  EXPECT_FALSE(besides.alone);
  EXPECT_FALSE(outcome_of(Category::one, {"drag"}, diagnosed(Verdict::unexplained, {})).found);
}

TEST(Score, FindsOneInTheAmbiguitySetOfTheFirst) {
  const Outcome in_set =
      outcome_of(Category::one, {"heat"}, diagnosed(Verdict::explained, {"gain"}, {{"gain", "heat", "offset"}}));
  EXPECT_TRUE(in_set.found);
  EXPECT_FALSE(in_set.alone);
  // A set without the first reported effect says nothing about it.
  EXPECT_FALSE(outcome_of(Category::one, {"heat"}, diagnosed(Verdict::explained, {"gain"}, {{"creep", "heat"}})).found);
  // First and right, but not distinguished from another.
  const Outcome unsure =
      outcome_of(Category::one, {"heat"}, diagnosed(Verdict::explained, {"heat"}, {{"heat", "gain"}}));
  EXPECT_TRUE(unsure.found);
  EXPECT_FALSE(unsure.alone);
}

TEST(Score, NeedsBothOfTwo) {
  const auto of = [](const Diagnosis& diagnosis) {
    return outcome_of(Category::two, {"drag", "tilt"}, diagnosis).found;
  };
  EXPECT_TRUE(of(diagnosed(Verdict::explained, {"tilt", "drag"})));
  EXPECT_TRUE(of(diagnosed(Verdict::explained, {"rest", "drag"}, {{"tilt", "rest"}})));
  EXPECT_FALSE(of(diagnosed(Verdict::partly_explained, {"drag"})));
  EXPECT_FALSE(of(diagnosed(Verdict::partly_explained, {"drag"}, {{"tilt", "rest"}})));
  EXPECT_FALSE(of(diagnosed(Verdict::unexplained, {})));
}

TEST(Score, IsDeterminedIfTheEffectIsVisibleWithoutConfounders) {
  truth::Answer answer = hiding({"drag"});
  const auto determined = [&] { return score(asked, answer, diagnosed(Verdict::explained, {"drag"})).determined; };
  EXPECT_TRUE(determined());
  answer.hidden[0].confounders = {"creep"};
  EXPECT_FALSE(determined());
  answer.hidden[0].confounders.clear();
  answer.hidden[0].visible = false;
  EXPECT_FALSE(determined());
}

TEST(Score, CountsTrueValuesInsideIntervals) {
  truth::Answer answer = hiding({"friction"});
  answer.joint_stiffness = 0.0125;
  answer.joint_damping = 1.3e-4;
  answer.hidden[0].numbers = {
      {.key = "torque_Nmm", .value = 0.2}, {.key = "range_deg", .value = 10.0}, {.key = "side", .value = 1.0}};
  Diagnosis diagnosis = diagnosed(Verdict::explained, {"friction"});
  diagnosis.effects[0].parameters = {{.key = "torque_Nmm", .value = 0.21e-3, .lower = 0.19e-3, .upper = 0.23e-3},
                                     {.key = "range_deg", .value = 0.3, .lower = 0.28, .upper = 0.32},
                                     {.key = "side", .value = 1.0, .lower = 0.0, .upper = 0.5}};
  diagnosis.calibration = {{.key = "joint_stiffness_Nmm_rad", .value = 0.0124, .lower = 0.0123, .upper = 0.0126},
                           {.key = "joint_damping_Nmms_rad", .value = 2e-4, .lower = 1.9e-4, .upper = 2.1e-4}};
  Outcome outcome = score(asked, answer, diagnosis);
  EXPECT_EQ(outcome.effect_intervals.of, 2);  // a side has none
  EXPECT_EQ(outcome.effect_intervals.hits, 1);
  EXPECT_EQ(outcome.calibration_intervals.of, 2);
  EXPECT_EQ(outcome.calibration_intervals.hits, 1);

  // Parameters that the data do not determine are not counted.
  diagnosis.effects[0].parameters[1].determined = false;
  diagnosis.effects[0].parameters[0].upper = std::numeric_limits<double>::infinity();
  EXPECT_EQ(score(asked, answer, diagnosis).effect_intervals.of, 0);

  // With another effect reported in addition, intervals are not counted.
  diagnosis.effects.push_back({.kind = named("creep"), .parameters = {}});
  EXPECT_EQ(score(asked, answer, diagnosis).calibration_intervals.of, 0);
}

TEST(Score, MeasuresTheErrorRelativeToTheTrueNoise) {
  truth::Answer answer = hiding({"drag"});
  answer.noise = 3e-3;
  answer.resolution = 4e-3 * std::sqrt(12.0);  // as much as 4e-3 of noise: together 5e-3
  Diagnosis diagnosis = diagnosed(Verdict::explained, {"drag"});
  EXPECT_FALSE(score(asked, answer, diagnosis).error_over_floor);
  diagnosis.validate_errors.resize(1);
  diagnosis.validate_errors[0].after.rmse = 6e-3;
  diagnosis.validate_errors[0].noise_floor_rmse = 9e-3;  // the estimate of the diagnosis does not matter
  EXPECT_DOUBLE_EQ(*score(asked, answer, diagnosis).error_over_floor, 1.2);
}

}  // namespace
}  // namespace attribution
