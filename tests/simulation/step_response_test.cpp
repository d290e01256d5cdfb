#include "coilwright/simulation/step_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "coilwright/simulation/transient.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;

struct Measures {
  double peak_speed = 0.0;
  double peak_time = 0.0;
  double peak_angle = 0.0;
  double peak_joint_angle = 0.0;
  double overshoot = 0.0;
  double rise = 0.0;
  double settling = 0.0;
  JointVector end;
};

// The same figures from a motion sampled every few microseconds, with no thought.
Measures by_brute_force(const Model& model, const StepInput& sampled, const JointVector& rest, const JointVector& end) {
  const ModelInput input = step_input(model, sampled);
  const std::vector<State> motion =
      simulate(model, input, {.angles = rest, .rates = straight(model)}, {.relative = 1e-9});
  Measures out;
  out.end = motion.back().angles;
  // A motion that creeps to its end has not arrived at the last sample.
  out.peak_angle = std::max(rest.sum(), end.sum());
  out.peak_joint_angle = end.lpNorm<Eigen::Infinity>();
  const double change = end.sum() - rest.sum();
  double tenth = -1.0;
  double ninth = -1.0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double time = input.times[i];
    const double speed = std::abs(motion[i].rates.sum());
    const double progress = (motion[i].angles.sum() - rest.sum()) / change;
    if (speed > out.peak_speed) {
      out.peak_speed = speed;
      out.peak_time = time;
    }
    out.peak_angle = std::max(out.peak_angle, motion[i].angles.sum());
    out.peak_joint_angle = std::max(out.peak_joint_angle, motion[i].angles.lpNorm<Eigen::Infinity>());
    out.overshoot = std::max(out.overshoot, progress - 1.0);
    if (tenth < 0.0 && progress >= 0.1) tenth = time;
    if (ninth < 0.0 && progress >= 0.9) ninth = time;
    if (std::abs(progress - 1.0) > 0.02) out.settling = time;
  }
  out.rise = ninth - tenth;
  return out;
}

void expect_as_brute_force(const Model& model, const StepInput& sampled) {
  const double current = sampled.current;
  const double interval = sampled.interval;
  const JointVector rest = rest_of(model);
  const auto step = step_response(model, model.all_coils(current), rest);
  ASSERT_TRUE(step && step->rise_time && step->settling_time);
  const Measures brute = by_brute_force(model, sampled, rest, step->steady_angles);
  // 1e-5 of a step's tolerance, and the speed lost between samples; times to one sample and 1e-4.
  EXPECT_NEAR(step->peak_speed, brute.peak_speed, 1e-5 * brute.peak_speed);
  EXPECT_NEAR(step->peak_speed_time, brute.peak_time, 2.0 * interval);
  EXPECT_NEAR(step->overshoot, brute.overshoot, 2e-5);
  // 1e-5 of a step's tolerance over some ten steps; a turning point between samples is lower by far less.
  EXPECT_NEAR(step->peak_angle, brute.peak_angle, 2e-5);
  EXPECT_NEAR(step->peak_joint_angle, brute.peak_joint_angle, 2e-5);
  EXPECT_NEAR(*step->rise_time, brute.rise, 2.0 * interval);
  EXPECT_NEAR(*step->settling_time, brute.settling, 2.0 * interval + 1e-4 * brute.settling);
  EXPECT_LT((step->steady_angles - brute.end).lpNorm<Eigen::Infinity>(),
            0.02 * std::abs(step->steady_angles.sum() - rest.sum()));
}

TEST(StepResponse, OfTheFingerIsWhatBruteForceMeasures) {
  expect_as_brute_force(finger(Configuration::B).model, {.current = 1.4, .duration = 1.5, .interval = 1e-5});
}

TEST(StepResponse, OfOneJointIsWhatBruteForceMeasures) {
  expect_as_brute_force(finger(Configuration::A).model, {.current = 0.9, .duration = 0.6, .interval = 1e-5});
}

TEST(StepResponse, OfAnOverdampedFingerIsWhatBruteForceMeasures) {
  const Model slow = with_hinges(finger(Configuration::B).model, [](actuator::Hinge& hinge) { hinge.damping *= 40.0; });
  expect_as_brute_force(slow, {.current = 1.4, .duration = 4.0, .interval = 1e-5});
  EXPECT_EQ(step_response(slow, slow.all_coils(1.4), rest_of(slow))->overshoot, 0.0);
}

// The peak is where the first stop is met, at a kink: samples must lie closer to see it to five digits.
TEST(StepResponse, OntoTheStopsIsWhatBruteForceMeasures) {
  expect_as_brute_force(finger(Configuration::B).model, {.current = -1.4, .duration = 0.3, .interval = 1e-6});
}

TEST(StepResponse, OfATinyCurrentIsWhatBruteForceMeasures) {
  expect_as_brute_force(finger(Configuration::B).model, {.current = 1e-3, .duration = 1.5, .interval = 1e-5});
}

TEST(StepResponse, OfNoCurrentIsNoMotion) {
  const Model model = finger(Configuration::B).model;
  const auto step = step_response(model, model.all_coils(0.0), rest_of(model));
  ASSERT_TRUE(step.has_value());
  EXPECT_LT(step->peak_speed, 1e-9);
  EXPECT_EQ(step->overshoot, 0.0);
  EXPECT_FALSE(step->rise_time.has_value());
  EXPECT_FALSE(step->settling_time.has_value());
}

TEST(StepResponse, IsNothingWhereTheMotionDoesNotDieDown) {
  const Model lossless =
      with_hinges(finger(Configuration::B).model, [](actuator::Hinge& hinge) { hinge.damping = 0.0; });
  EXPECT_FALSE(step_response(lossless, lossless.all_coils(1.4), rest_of(lossless), {.longest = 0.5}).has_value());
}

// The tolerance that is used without asking: what it costs in accuracy, printed and bounded.
TEST(StepResponse, ConvergesWithItsTolerance) {
  const Model model = finger(Configuration::B).model;
  const JointVector rest = rest_of(model);
  const auto with = [&](double accuracy) {
    return step_response(model, model.all_coils(1.4), rest, {.relative_accuracy = accuracy}).value();
  };
  const StepResponse best = with(1e-12);
  std::printf("  tolerance  peak speed  overshoot  rise time  settling (relative errors)\n");
  for (const double accuracy : {1e-4, 1e-5, 1e-6, 1e-7}) {
    const StepResponse step = with(accuracy);
    std::printf("  %9.0e  %10.1e  %9.1e  %9.1e  %8.1e\n", accuracy, step.peak_speed / best.peak_speed - 1.0,
                step.overshoot / best.overshoot - 1.0, *step.rise_time / *best.rise_time - 1.0,
                *step.settling_time / *best.settling_time - 1.0);
  }
  const StepResponse standard = step_response(model, model.all_coils(1.4), rest).value();
  EXPECT_NEAR(standard.peak_speed, best.peak_speed, 1e-5 * best.peak_speed);
  EXPECT_NEAR(*standard.settling_time, *best.settling_time, 1e-4 * *best.settling_time);
  EXPECT_LT(std::abs(with(1e-7).peak_speed - best.peak_speed), 0.1 * std::abs(standard.peak_speed - best.peak_speed));
}

}  // namespace
}  // namespace coilwright::simulation
