#include "measurement/replay/window_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "coilwright/simulation/transient.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/random_numbers.hpp"
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

// The largest angle of a motion under `exact`, and the largest difference that `smooth` makes, at the samples.
struct Differences {
  double largest{}, apart{};
};

Differences differences_of(const data::Run& run, const simulation::ModelInput& exact,
                           const simulation::ModelInput& smooth) {
  const simulation::State start{.angles = mechanics::JointVector::Zero(1), .rates = mechanics::JointVector::Zero(1)};
  const auto motion = [&](const simulation::ModelInput& input) {
    return simulation::simulate_at(swing(), input, start, run.times, {.relative = 1e-10});
  };
  const std::vector<simulation::State> by_samples = motion(exact);
  const std::vector<simulation::State> by_curve = motion(smooth);
  Differences out;
  for (std::size_t i = 0; i < by_samples.size(); ++i) {
    out.largest = std::max(out.largest, std::abs(by_samples[i].angles[0]));
    out.apart = std::max(out.apart, std::abs(by_samples[i].angles[0] - by_curve[i].angles[0]));
  }
  return out;
}

Window swing_window(const data::Run& run, double sigma) {
  Window out{.range = {0, run.times.size()}};
  set_input(out, run, {.rows = run.inputs, .sigma = sigma}, swing());
  return out;
}

// The same by another way: every step, or every line, is integrated by itself. Without the terms of (w h)^2 of each the
// curve would be off by 7e-4 and 1.3e-3 at 10 Hz.
TEST(WindowInput, IsASmoothCurveThatMovesAFingerAsFineStepsDo) {
  for (const double frequency : {0.5, 2.0, 10.0})
    for (const double sigma : {0.0, 1e-3}) {
      const data::Run run = swing_run(frequency);
      const Window window = swing_window(run, sigma);
      EXPECT_GT(std::ranges::count(window.input.passed, 1), 700);
      const Differences found = differences_of(run, simulation::model_input(swing(), run.command()), window.input);
      EXPECT_GT(found.largest, 1.0) << frequency;
      EXPECT_LT(found.apart, 4e-5 * found.largest) << frequency;
    }
}

TEST(WindowInput, IsASmoothCurveThatMovesAFingerAsFineLinesDo) {
  for (const double frequency : {0.5, 2.0, 10.0}) {
    data::Run run = swing_run(frequency);
    run.hold = data::InputHold::linear;
    // The step as a ramp of 50 samples, which is no edge.
    for (std::size_t i = 0; i < run.inputs.size(); ++i)
      run.inputs[i][0] *= std::clamp((run.times[i] - 0.2) / 0.1, 0.0, 1.0);
    simulation::ModelInput lines = simulation::model_input(swing(), run.command());
    lines.straight.assign(lines.times.size(), 1);
    lines.straight.back() = 0;
    const Window window = swing_window(run, 0.0);
    EXPECT_GT(std::ranges::count(window.input.passed, 1), 700);
    const Differences found = differences_of(run, lines, as_driven(window, {.edges = {}, .bend = 0.0, .errors = {}}));
    EXPECT_GT(found.largest, 1.0) << frequency;
    EXPECT_LT(found.apart, 4e-5 * found.largest) << frequency;
  }
}

// Whether it is cut off between two samples or at one.
TEST(WindowInput, EndsAnywhereInASmoothCurve) {
  data::Run run = swing_run(2.0);
  run.hold = data::InputHold::linear;
  std::size_t at_samples = 0;
  for (std::size_t samples = 800; samples < 900; ++samples) {
    Window window{.range = {0, samples}};
    set_input(window, run, {.rows = run.inputs}, swing());
    EXPECT_NO_THROW(window.input.require_fits(swing())) << samples;
    at_samples += static_cast<std::size_t>(std::ranges::count(run.times, window.input.times.back()));
  }
  EXPECT_GT(at_samples, 0U);
}

// A command of few steps, of uneven or of rough ones, is made step by step.
TEST(WindowInput, KeepsStepsThatAreFewUnevenOrRough) {
  data::Run rough = swing_run(2.0);
  Normal normal(1);
  for (std::vector<double>& row : rough.inputs) row[0] += 20.0 * normal();  // of 2500
  EXPECT_TRUE(swing_window(rough, 0.0).input.straight.empty());
  data::Run uneven = swing_run(2.0);
  for (std::size_t i = 1; i < uneven.times.size(); i += 2) uneven.times[i] += 3e-4;
  EXPECT_TRUE(swing_window(uneven, 0.0).input.straight.empty());
  data::Run few = swing_run(0.5);
  for (std::size_t i = 0; i < few.inputs.size(); ++i) few.inputs[i] = {i < 500 ? 0.0 : (i < 600 ? 1000.0 : 1100.0)};
  EXPECT_TRUE(swing_window(few, 0.0).input.straight.empty());
}

// What an instrument rounds, and a ramp, are as smooth as they look.
TEST(WindowInput, IsASmoothCurveOfRoundedSamplesAndOfARamp) {
  data::Run rounded = swing_run(2.0);
  for (std::vector<double>& row : rounded.inputs) row[0] = std::round(row[0]);  // 2500 steps of the range
  const Window window = swing_window(rounded, 0.0);
  EXPECT_GT(std::ranges::count(window.input.passed, 1), 700);
  const Differences found = differences_of(rounded, simulation::model_input(swing(), rounded.command()), window.input);
  EXPECT_LT(found.apart, 4e-5 * found.largest);
  data::Run ramp = swing_run(2.0);
  ramp.hold = data::InputHold::linear;
  for (std::size_t i = 0; i < ramp.inputs.size(); ++i)
    ramp.inputs[i] = {std::min(1000.0, 0.9 * static_cast<double>(i))};
  EXPECT_GT(std::ranges::count(swing_window(ramp, 0.0).input.passed, 1), 1000);
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
