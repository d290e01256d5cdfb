#include "measurement/records/suspect_records.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "measurement/slider_model.hpp"

namespace coilwright::measurement::records {
namespace {

constexpr double declared_stiffness = 100.0;  // Nm/rad

// A record in which the torque steps half-way to what holds the declared model at `held`, rad, and the angle to `seen`.
data::Run stepped(double held, double seen) {
  data::Run run = slide_run(50, {}, no_error);
  run.start = data::Start::at_rest;
  for (std::size_t i = 0; i < run.inputs.size(); ++i) {
    const bool on = i >= run.inputs.size() / 2;
    run.inputs[i] = {on ? held * declared_stiffness : 0.0};
    run.channels.front().values[i] = (on ? seen : 0.0) + (i % 2 == 0 ? 1e-3 : -1e-3);
  }
  return run;
}

std::vector<data::Warning> warnings_of(const std::vector<data::Run>& runs) {
  replay::DeclaredModel declared = slide(true_mass, 0.1);
  declared.build = [](std::span<const double> values) {
    actuator::ModelSpec spec = slide(true_mass, 0.1).build(values);
    spec.hinges.front().stiffness = declared_stiffness;
    spec.hinges.front().damping = 2.0 * declared_stiffness;  // seconds in which it creeps there, without ringing
    return spec;
  };
  return unanswered_runs(runs, declared);
}

TEST(UnansweredRuns, AreThoseInWhichTheAngleStaysWhereTheModelMovesFar) {
  const auto warnings = warnings_of({stepped(0.8, 0.4), stepped(0.8, 0.0)});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().run, "slide.csv");
  EXPECT_EQ(warnings.front().text.substr(0, 52), "theta1_rad keeps within 0.11 deg where the declared ");
  EXPECT_NE(warnings.front().text.find("a coil, a wire, the driver or the camera may have been off. If so, leave the "
                                       "run out"),
            std::string::npos);
}

TEST(UnansweredRuns, AreStillFoundWherePicturesWereMisread) {
  data::Run run = stepped(0.8, 0.0);
  for (std::size_t i = 0; i < run.inputs.size(); i += 12) run.channels.front().values[i] = 0.5;
  EXPECT_EQ(warnings_of({run}).size(), 1U);
}

// A wire that comes loose: the torque goes on, and the finger falls back.
data::Run loose_from(std::size_t first, std::size_t last) {
  data::Run run = stepped(0.8, 0.0);
  double angle = 0.0;
  for (std::size_t i = 0; i < run.inputs.size(); ++i) {
    const double held = i < 10 ? 0.0 : 0.8;
    run.inputs[i] = {held * declared_stiffness};
    angle += 0.5 * ((i >= first && i < last ? 0.0 : held) - angle);
    run.channels.front().values[i] = angle + (i % 2 == 0 ? 1e-3 : -1e-3);
  }
  return run;
}

// As above, but the declared model follows its torque within a sample or two.
std::vector<data::Warning> warnings_of_quick(const std::vector<data::Run>& runs) {
  replay::DeclaredModel declared = slide(0.01, 0.1);
  declared.build = [](std::span<const double> values) {
    actuator::ModelSpec spec = slide(0.01, 0.1).build(values);
    spec.hinges.front().stiffness = declared_stiffness;
    spec.hinges.front().damping = interval * declared_stiffness;
    return spec;
  };
  return unanswered_runs(runs, declared);
}

TEST(UnansweredRuns, AreThoseInWhichTheAngleFallsBackAndStays) {
  const auto at_the_end = warnings_of_quick({loose_from(25, 50)});
  ASSERT_EQ(at_the_end.size(), 1U);
  EXPECT_EQ(at_the_end.front().text,
            "from 0.28 to 0.49 s theta1_rad stays where the finger rests without current, and the declared model is "
            "bent by up to 46 deg there: a coil, a wire, the driver or the camera may have been off. If so, end the "
            "record before that: a fit would explain it by effects that are not there. If the current did flow, "
            "something holds the finger");
  EXPECT_EQ(warnings_of_quick({loose_from(20, 45)}).size(), 1U);
}

// One that never fell back, for a moment only, or that was late: what a camera's delay shows as well.
TEST(UnansweredRuns, AreNoneWhereTheAngleAnswersLateOrFallsBackForAMoment) {
  EXPECT_TRUE(warnings_of_quick({loose_from(50, 50)}).empty());
  EXPECT_TRUE(warnings_of_quick({loose_from(20, 30)}).empty());
  EXPECT_TRUE(warnings_of_quick({loose_from(0, 35)}).empty());
}

// Little motion is asked for, another start is not known, and a tenth of the motion is an answer.
TEST(UnansweredRuns, AreNoneWhereTheModelHardlyMovesOrTheStartIsFree) {
  EXPECT_TRUE(warnings_of({stepped(0.01, 0.0)}).empty());
  EXPECT_TRUE(warnings_of({stepped(0.8, 0.08)}).empty());
  data::Run run = stepped(0.8, 0.0);
  run.start = data::Start::free;
  EXPECT_TRUE(warnings_of({run}).empty());
}

}  // namespace
}  // namespace coilwright::measurement::records
