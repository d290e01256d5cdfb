#include "measurement/replay/window_input.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "measurement/fit/hypothesis.hpp"
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

}  // namespace
}  // namespace coilwright::measurement::replay
