#include "measurement/replay/window_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "coilwright/simulation/transient.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::replay {
namespace {

actuator::Model nominal() {
  static const DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  return hypothesis.model_at(hypothesis.start());
}

Window window_of(const data::Run& run) {
  Window out{.range = {0, run.samples()}};
  set_input(out, run, {.rows = run.inputs}, nominal());
  return out;
}

// The force in the rows of the input at a time.
double force_in(const simulation::ModelInput& input, double time) {
  const auto after = std::upper_bound(input.times.begin(), input.times.end(), time);
  const auto row = static_cast<std::size_t>(after - input.times.begin() - 1);
  const double from = input.joint_torques[row][0];
  if (!input.goes_straight(row)) return from;
  const double share = (time - input.times[row]) / (input.times[row + 1] - input.times[row]);
  return from + share * (input.joint_torques[row + 1][0] - from);
}

TEST(WindowInput, HoldsEachSampleUntilTheNext) {
  const data::Run run = slide_run(150, {}, no_error);
  const Window window = window_of(run);
  EXPECT_TRUE(window.edges.empty());
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    EXPECT_EQ(force_in(window.input, run.times[i] + 1e-9), force_at(i)) << i;
    EXPECT_EQ(force_in(window.input, run.times[i] + 0.99 * interval), force_at(i)) << i;
  }
  // Rows are dense, and go on beyond the last sample.
  for (std::size_t i = 1; i < window.input.times.size(); ++i)
    EXPECT_LE(window.input.times[i] - window.input.times[i - 1], 0.004 + 1e-9);
  EXPECT_GE(window.input.times.back(), run.times.back() + 0.05 - 1e-12);
}

TEST(WindowInput, ReachesAsFarAsTheClocksMayBeApart) {
  data::Run run = slide_run(150, {}, no_error);
  run.clock = {.offset_sigma = 0.1, .exposure = 0.02};
  EXPECT_NEAR(window_of(run).input.times.back(), run.times.back() + 0.05 + 0.4 + 0.01, 1e-9);
}

TEST(WindowInput, HasEdgesThatLieAnywhereBetweenTwoSamples) {
  data::Run run = slide_run(150, {}, no_error);
  run.hold = data::InputHold::unknown_within_sample;
  const Window window = window_of(run);
  ASSERT_EQ(window.edges.size(), 2u);  // at 0.5 s and 1 s
  for (std::size_t e = 0; e < 2; ++e) {
    EXPECT_NEAR(window.edges[e].half_width, 0.5 * interval, 1e-12);
    // The samples at 0.49 s and 0.5 s differ.
    EXPECT_NEAR(window.input.times[window.edges[e].row], 0.5 * static_cast<double>(e + 1) - 0.5 * interval, 1e-9);
  }
  const std::vector<double> numbers{window.edges[0].number(0.003), -20.0};
  const simulation::ModelInput moved = as_driven(window, {.edges = numbers});
  EXPECT_EQ(force_in(moved, 0.4979), force_at(49));
  EXPECT_EQ(force_in(moved, 0.4981), force_at(50));
  // Never beyond the sample that it precedes.
  EXPECT_EQ(force_in(moved, 0.99), force_at(99));
  EXPECT_EQ(force_in(moved, 0.9905), force_at(100));
  for (std::size_t i = 1; i < moved.times.size(); ++i) EXPECT_GT(moved.times[i], moved.times[i - 1]) << i;
}

TEST(WindowInput, GoesStraightWhereItIsLinear) {
  data::Run run = slide_run(100, {}, no_error);
  run.hold = data::InputHold::linear;
  for (std::size_t i = 0; i < run.inputs.size(); ++i) run.inputs[i] = {3.0 * run.times[i]};
  const Window window = window_of(run);
  for (const double time : {0.1003, 0.3331, 0.7777}) EXPECT_NEAR(force_in(window.input, time), 3.0 * time, 1e-12);
  // The impulse is that of the straight line.
  double impulse = 0.0;
  for (std::size_t i = 0; i + 1 < window.input.times.size() && window.input.times[i] < run.times.back(); ++i)
    impulse += 0.5 * (window.input.joint_torques[i][0] + window.input.joint_torques[i + 1][0]) *
               (window.input.times[i + 1] - window.input.times[i]);
  const double end = run.times.back();
  EXPECT_NEAR(impulse, 1.5 * end * end, 1e-9);
}

TEST(WindowInput, AtTheSamplesIsWhatWasCommanded) {
  const data::Run run = slide_run(60, {}, no_error);
  const Window window = window_of(run);
  const simulation::ModelInput samples = at_samples(window, run);
  ASSERT_EQ(samples.times, run.times);
  for (std::size_t i = 0; i < run.samples(); ++i) EXPECT_EQ(samples.joint_torques[i][0], force_at(i)) << i;
}

// A mass on a spring and a damper that swings at 8 Hz, as a finger does.
actuator::Model swing() {
  const mechanics::Link link{.length = 1.0, .com_along = 1.0, .com_offset = 0.0, .mass = 1.0, .inertia = 0.0};
  const double rate = 2.0 * std::numbers::pi * 8.0;
  return actuator::Model({.chain = mechanics::PlanarChain(std::span(&link, 1), 0.0),
                          .hinges = {actuator::Hinge{.stiffness = rate * rate, .damping = 0.1 * rate}},
                          .magnetics = {},
                          .coils = 0,
                          .tip = {}});
}

// A step, a hold, and a sine of so many Hz, each held for 2 ms, so large that the step alone would turn it by one.
data::Run swing_run(double frequency) {
  constexpr double step = 0.002;
  const double stiffness = std::pow(2.0 * std::numbers::pi * 8.0, 2);
  data::Run run{.kind = data::RunKind::transient, .drive = simulation::Drive::torque};
  for (int i = 0; i < 1500; ++i) {
    const double time = step * i;
    const double sine = std::max(0.0, time - 1.0) * 2.0 * std::numbers::pi * frequency;
    run.times.push_back(time);
    run.inputs.push_back({time < 0.2 ? 0.0 : stiffness * std::cos(sine)});
  }
  return run;
}

// The same by another way: every step is integrated by itself.
TEST(WindowInput, TakesTheFineStepsOfASmoothedReadingAsTheirMiddles) {
  const actuator::Model model = swing();
  for (const double frequency : {0.5, 2.0, 10.0}) {
    const data::Run run = swing_run(frequency);
    Window exact{.range = {0, run.times.size()}};
    Window smooth{.range = {0, run.times.size()}};
    set_input(exact, run, {.rows = run.inputs}, model);
    set_input(smooth, run, {.rows = run.inputs, .sigma = 1e-3}, model);
    EXPECT_TRUE(exact.input.straight.empty());
    ASSERT_FALSE(smooth.input.straight.empty());
    const simulation::State start{.angles = mechanics::JointVector::Zero(1), .rates = mechanics::JointVector::Zero(1)};
    const auto motion = [&](const Window& window) {
      return Trajectory{.times = window.input.times,
                        .states = simulation::simulate(model, window.input, start, {.relative = 1e-9})};
    };
    const Trajectory by_steps = motion(exact);
    const Trajectory by_middles = motion(smooth);
    double largest = 0.0;
    double apart = 0.0;
    for (const double time : run.times) {
      largest = std::max(largest, std::abs(by_steps.at(time).angles[0]));
      apart = std::max(apart, std::abs(by_steps.at(time).angles[0] - by_middles.at(time).angles[0]));
    }
    EXPECT_GT(largest, 1.0) << frequency;
    // Straight lines take twice as much from a sine as holding does: (w h)^2 / 12 of it.
    const double phase = 2.0 * std::numbers::pi * frequency * 0.002;
    EXPECT_LT(apart, (phase * phase / 24.0 + 1e-5) * largest) << frequency;
    EXPECT_GT(std::ranges::count(smooth.input.passed, 1), frequency < 5.0 ? 700 : 0) << frequency;
  }
}

// Steps that are long beside the motion are made one by one.
TEST(WindowInput, KeepsLongStepsOfASmoothedReading) {
  data::Run run = swing_run(0.5);
  for (std::size_t i = 0; i < run.times.size(); ++i) run.times[i] *= 3.0;
  Window window{.range = {0, run.times.size()}};
  set_input(window, run, {.rows = run.inputs, .sigma = 1e-3}, swing());
  EXPECT_TRUE(window.input.straight.empty());
}

}  // namespace
}  // namespace coilwright::measurement::replay
