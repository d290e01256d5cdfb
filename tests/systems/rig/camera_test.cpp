#include "coilwright/systems/rig/camera.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "degree.hpp"

namespace coilwright::systems::rig {
namespace {

using actuator::Design;
using testing::ThrowsMessage;

constexpr auto centres = magnetics::Fidelity::line_of_centres;

// The errata's own computation (tests/data/actuator_SOURCES.md): at rest 21.07 degrees, steady 38.29, 48.98, 57.04 and
// 63.62, and at most 1708 degrees a second at 1.4 A. Two digits behind the point, four of the speed; a frame's mean
// speed is a ten-thousandth below the fastest.
TEST(Camera, ShowsTheStepsOfTheErrata) {
  const auto records = readings(actuator::paper_finger(), {.step_duration = 3.0, .frequencies = {}});
  ASSERT_EQ(records.size(), 4U);
  const double steady[] = {38.29, 48.98, 57.04, 63.62};
  for (std::size_t i = 0; i < records.size(); ++i) {
    const ResponseFigures shown = figures(records[i], centres);
    EXPECT_NEAR(shown.first / degree, 21.07, 5.1e-3);
    EXPECT_NEAR(shown.last / degree, steady[i], 5.1e-3);
    EXPECT_GT(shown.largest, shown.last);  // it rings
  }
  EXPECT_NEAR(figures(records[3], centres).fastest / degree, 1708.0, 0.7);
  EXPECT_EQ(records[3].name(), "step_1.4A");
  EXPECT_EQ(records[0].name(), "step_0.35A");
}

TEST(Camera, HasFramesAndTheCommandOfEquation23) {
  const auto records =
      readings(actuator::paper_finger(), {.steps = {1.4}, .step_duration = 0.2, .frequencies = {10.0}});
  const CameraRecord& step = records[0];
  ASSERT_EQ(step.times.size(), 401U);
  EXPECT_EQ(step.times[1], 0.0005);
  EXPECT_EQ(step.currents[199], 0.0);
  EXPECT_EQ(step.currents[200], 1.4);
  const CameraRecord& sine = records[1];
  EXPECT_EQ(sine.name(), "sine_10Hz");
  ASSERT_EQ(sine.times.size(), 2001U);
  EXPECT_NEAR(sine.currents[50], 1.4, 1e-12);  // a quarter of a period
  EXPECT_NEAR(sine.currents[150], 0.0, 1e-12);
  EXPECT_EQ(sine.currents[0], 0.7);
}

// So slow a sine is a row of equilibria. What the damper holds back is of second order where the motion turns, inertia
// adds (0.02 Hz / 7 Hz)^2, and the frame nearest to a turn is at most 1e-6 of the swing off it.
TEST(Camera, FollowsASlowSineFromPoseToPose) {
  const auto record =
      readings(actuator::paper_finger(), {.frame_rate = 200.0, .steps = {}, .frequencies = {0.02}}).front();
  for (const auto fidelity : {centres, magnetics::Fidelity::exact}) {
    const actuator::Model model = actuator::assemble_or_throw(with_fidelity(actuator::paper_finger(), fidelity)).model;
    const auto pose = [&](double current) {
      return simulation::find_equilibrium(model, model.all_coils(current), mechanics::JointVector::Zero(2))->sum();
    };
    const ResponseFigures shown = figures(record, fidelity);
    EXPECT_NEAR(shown.peak_to_peak, pose(1.4) - pose(0.0), 2e-3 * degree);
    EXPECT_NEAR(shown.first, pose(0.7), 1e-9);
  }
}

TEST(Camera, TakesItsFiguresFromTheFrames) {
  // Two periods of five frames; the last five are the late ones.
  CameraRecord record{.input = CameraInput::sine, .level = 2.0};
  for (int i = 0; i <= 10; ++i) record.times.push_back(0.1 * i);
  record.bending.exact = {0.0, 0.9, 0.2, 0.1, 0.0, 0.5, 0.3, 0.4, 0.1, 0.2, 0.25};
  record.bending.line_of_centres.assign(11, 0.25);
  const ResponseFigures shown = figures(record, magnetics::Fidelity::exact);
  EXPECT_EQ(shown.first, 0.0);
  EXPECT_EQ(shown.last, 0.25);
  EXPECT_EQ(shown.largest, 0.9);
  EXPECT_NEAR(shown.fastest, 9.0, 1e-12);
  EXPECT_NEAR(shown.late_mean, 0.25, 1e-15);
  EXPECT_NEAR(shown.peak_to_peak, 0.3, 1e-15);
  EXPECT_NEAR(mean_difference(record), (0.25 + 0.65 + 0.05 + 0.15 + 0.25 + 0.25 + 0.05 + 0.15 + 0.15 + 0.05) / 11.0,
              1e-15);
}

// What the camera adds is in what it shows.
TEST(Camera, ShowsAnOffsetOfItsOwn) {
  Design design = actuator::paper_finger();
  const Camera camera{.steps = {0.9}, .step_duration = 0.2, .frequencies = {}};
  const double bare = figures(readings(design, camera)[0], centres).first;
  design.effects = {{.kind = actuator::standard_effects().find("angle_offset"), .values = {0.05}}};
  EXPECT_NEAR(figures(readings(design, camera)[0], centres).first, bare + 0.05, 1e-12);
}

TEST(Camera, RefusesWhatItCannotFilm) {
  const Design finger = actuator::paper_finger();
  const auto refusal = [&](const Camera& camera) { return [&, camera] { return readings(finger, camera); }; };
  EXPECT_THAT(refusal({.steps = {}, .frequencies = {}}),
              ThrowsMessage<std::invalid_argument>("there must be at least one of steps and sines"));
  EXPECT_THAT(refusal({.steps = {0.7, 1.4, 0.7}}),
              ThrowsMessage<std::invalid_argument>("step must not be there twice; got 0.7 A"));
  EXPECT_THAT(
      refusal({.frame_rate = 50.0}),
      ThrowsMessage<std::invalid_argument>("frequency must be > 0 and at most a tenth of the frame rate; got 10 Hz"));
  EXPECT_THAT(refusal({.step_duration = 0.1}),
              ThrowsMessage<std::invalid_argument>("step duration must be finite and > 0.1; got 0.1 s"));
  EXPECT_THAT(refusal({.frequencies = {0.001}}),
              ThrowsMessage<std::invalid_argument>("frames of a sine must be at most 1000000; got 4e+06 frames"));
}

}  // namespace
}  // namespace coilwright::systems::rig
