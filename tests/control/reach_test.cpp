#include "coilwright/control/reach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/control/input_shaping.hpp"
#include "coilwright/simulation/step_response.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"
#include "degree.hpp"
#include "error_text.hpp"

namespace coilwright::control {
namespace {

using actuator::Model;

const Model& finger() {
  static const Model model = actuator::assemble_or_throw(systems::validation::paper_finger()).model;
  return model;
}

ReachTask to(double angle) {
  return {.angle = angle * degree, .lowest_current = 0.0, .highest_current = 1.4};
}

const Reach& fifty_degrees() {
  static const Reach found = reach(finger(), to(50.0));
  return found;
}

// A step's own measurement, by the energy that the motion has left, and not by looking at its samples.
TEST(Arrival, OfAPlainStepIsItsStepResponse) {
  const Arrival one = arrival(finger(), {.times = {0.0}, .levels = {1.1}}, 1.5);
  const mechanics::JointVector rest = mechanics::JointVector::Zero(2);
  const auto pose = simulation::step_response(finger(), finger().all_coils(0.0), rest);
  ASSERT_TRUE(pose.has_value());
  const auto step = simulation::step_response(finger(), finger().all_coils(1.1), pose->steady_angles);
  ASSERT_TRUE(step && step->settling_time);
  EXPECT_NEAR(*one.settling_time, *step->settling_time, 1e-3);  // two looks
  EXPECT_NEAR(one.overshoot, step->overshoot, 1e-3 * step->overshoot);
  EXPECT_NEAR(one.peak_speed, step->peak_speed, 1e-3 * step->peak_speed);
  EXPECT_NEAR(one.end, step->steady_angles.sum(), 1e-6);
}

TEST(Arrival, HasNoSettlingTimeWhereTheMotionIsLeftTooEarly) {
  EXPECT_FALSE(arrival(finger(), {.times = {0.0}, .levels = {1.1}}, 0.3).settling_time.has_value());
}

TEST(Arrival, SaysWhatIsWrongWithAProfile) {
  EXPECT_EQ(error_text([] { (void)arrival(finger(), {.times = {0.1}, .levels = {1.0}}, 1.0); }),
            "profile must have one level a time, the first at time 0");
  EXPECT_EQ(error_text([] {
              (void)arrival(finger(), {.times = {0.0, 0.5}, .levels = {1.0, 0.5}}, 0.4);
            }),
            "duration must be beyond the profile's last time, 0.5 s; got 0.4");
}

TEST(Reach, ArrivesSeveralTimesAsFastAsAStep) {
  const Reach& found = fifty_degrees();
  ASSERT_EQ(found.profiles.size(), 4u);
  for (const ProfileQuality& each : found.profiles) {
    EXPECT_NEAR(each.nominal.end, 50.0 * degree, 1e-6) << each.name;
    ASSERT_TRUE(each.worst.settling_time.has_value()) << each.name;
    EXPECT_GE(*each.worst.settling_time, *each.nominal.settling_time) << each.name;
  }
  const ProfileQuality& step = found.profiles.front();
  const ProfileQuality& searched = found.profiles.back();
  EXPECT_LT(*searched.worst.settling_time, 0.2 * *step.worst.settling_time);
  EXPECT_LE(searched.worst.time_outside, found.profiles[2].worst.time_outside);
  // Half a period of the slowest motion is the least that a push and a brake of such currents need.
  EXPECT_GT(*searched.nominal.settling_time, 0.25 / found.mode.natural_frequency);
  for (const double level : searched.profile.levels) {
    EXPECT_GE(level, 0.0);
    EXPECT_LE(level, 1.4);
  }
}

TEST(Reach, IsTheSameEachTime) {
  const Reach again = reach(finger(), to(50.0));
  EXPECT_EQ(again.profiles.back().profile.levels, fifty_degrees().profiles.back().profile.levels);
  EXPECT_EQ(again.profiles.back().profile.times, fifty_degrees().profiles.back().profile.times);
}

TEST(Reach, GoesBackAsWell) {
  ReachTask back = to(30.0);
  back.start_current = 1.2;
  const Reach found = reach(finger(), back);
  EXPECT_GT(found.profiles.front().nominal.start, 55.0 * degree);
  EXPECT_LT(found.current, 1.2);
  EXPECT_LT(*found.profiles.back().worst.settling_time, 0.5 * *found.profiles.front().worst.settling_time);
}

// A current that lags rounds a profile off; the search knows of it.
TEST(Reach, CountsTheEffectsOfTheModel) {
  actuator::ModelSpec spec = finger().nominal_spec();
  spec.effects.push_back({.kind = actuator::standard_effects().find("coil_lag"), .values = {0.02}});
  const Model lagging(std::move(spec));
  ReachTask task = to(50.0);
  task.pieces = 2;
  const Reach found = reach(lagging, task);
  const Arrival without = arrival(lagging, fifty_degrees().profiles.back().profile, found.duration);
  EXPECT_LT(*found.profiles.back().nominal.settling_time, without.settling_time.value_or(found.duration));
}

TEST(Reach, SaysWhatItCannotReach) {
  EXPECT_EQ(error_text([] { (void)reach(finger(), to(100.0)); }),
            "angle must be from 21.07 to 63.62 deg, which 0 to 1.4 A hold; got 100 deg");
  EXPECT_EQ(error_text([] {
              ReachTask task = to(40.0);
              task.stiffness_error = 0.6;
              (void)reach(finger(), task);
            }),
            "stiffness error must be from 0 to 0.5; got 0.6");
  EXPECT_EQ(error_text([] {
              ReachTask task = to(40.0);
              task.highest_current = -1.0;
              (void)reach(finger(), task);
            }),
            "highest current must be finite and above the lowest; got -1");
}

}  // namespace
}  // namespace coilwright::control
