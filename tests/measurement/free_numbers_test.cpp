#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/ball_on_a_string.hpp"

// What was declared of a number that is fitted freely is where somebody stood, not what the records say.
namespace coilwright::measurement {
namespace {

constexpr double true_length = 0.332;         // m
constexpr double true_damping = 6e-5;         // N m s/rad
constexpr double true_angles[] = {0.9, 0.4};  // rad, of two swings

std::vector<data::Run> swings(unsigned seed) {
  std::vector<data::Run> out;
  for (const double angle : true_angles) {
    out.push_back(Ball{.length = true_length, .damping = true_damping, .angle = angle}.filmed(30.0, 30.0, ++seed));
    out.back().name = fmt::format("swing_{}.csv", angle);
  }
  return out;
}

Diagnosis diagnosed(std::vector<data::Run> runs, double length, double damping, unsigned seed = 1) {
  data::Dataset data;
  data.fit = std::move(runs);
  return diagnose(data, declared_ball(length, damping).model, {.threads = 2, .seed = seed});
}

void expect_nothing_missing(const Diagnosis& found) {
  EXPECT_EQ(name_of(found.verdict), "no_missing_effect");
  EXPECT_TRUE(found.effects.empty());
  ASSERT_EQ(found.calibration.size(), 2u);
  EXPECT_LE(found.calibration[0].lower, true_damping);
  EXPECT_GE(found.calibration[0].upper, true_damping);
  EXPECT_LE(found.calibration[1].lower, true_length);
  EXPECT_GE(found.calibration[1].upper, true_length);
}

TEST(FreeNumbers, LeadToTheSameAnswerWhateverWasDeclaredOfThem) {
  double length = 0.9 * true_length;
  for (const double damping : {0.0, 1e-7, 1e-5, 1e-3}) {
    SCOPED_TRACE(fmt::format("declared {} N m s/rad, {} m", damping, length));
    expect_nothing_missing(diagnosed(swings(7), length, damping));
    length *= 1.05;
  }
}

TEST(FreeNumbers, LeadToTheSameAnswerInAnyOrderOfTheRunsAndFromAnySeed) {
  for (const unsigned seed : {1u, 2u}) {
    std::vector<data::Run> runs = swings(11);
    std::ranges::reverse(runs);
    expect_nothing_missing(diagnosed(std::move(runs), 1.02 * true_length, 1e-6, seed));
  }
}

// Friction and drag together slow a swing as a damping does that is fitted: each alone improves little, and their
// directions beside the fitted damping lead nowhere.
TEST(FreeNumbers, DoNotHideTwoEffectsThatImitateThemTogether) {
  data::Dataset data;
  unsigned seed = 3;
  const auto swing = [&](double angle) {
    data::Run run = Ball{.damping = 1e-7, .angle = angle, .noise = 0.001, .friction = 3e-5, .drag = 1.6e-5}.filmed(
        20.0, 30.0, ++seed);
    run.name = fmt::format("swing_{}.csv", angle);
    return run;
  };
  for (const double angle : true_angles) data.fit.push_back(swing(angle));
  data.validate = data::SealedRuns({swing(0.6)});
  const Diagnosis found = diagnose(data, declared_ball(true_length, 1e-4).model, {.threads = 2});
  std::vector<std::string> names;
  for (const AddedEffect& each : found.effects) names.emplace_back(each.kind->id());
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"dry_friction", "quadratic_drag"}));
}

}  // namespace
}  // namespace coilwright::measurement
