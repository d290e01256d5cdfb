#include "measurement/records/suspect_records.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "measurement/fit/hypothesis.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::records {
namespace {

constexpr double stiffness = 100.0;  // Nm/rad

// A record at rest under a constant torque, all of which reads `angle`, rad.
data::Run run_at(double angle, double torque, double noise = 1e-3) {
  data::Run run = slide_run(50, {}, no_error);
  run.start = data::Start::at_rest;
  run.sigma = noise;
  for (auto& row : run.inputs) row = {torque};
  for (double& value : run.channels.front().values) value = angle;
  return run;
}

std::optional<data::Warning> warning_of(const std::vector<data::Run>& runs) {
  replay::DeclaredModel declared = slide(true_mass, 0.1);
  declared.build = [](std::span<const double> values) {
    actuator::ModelSpec spec = slide(true_mass, 0.1).build(values);
    spec.hinges.front().stiffness = stiffness;
    return spec;
  };
  const fit::Hypothesis hypothesis(declared, {});
  std::vector<replay::PreparedRun> prepared;
  for (const data::Run& run : runs)
    prepared.push_back(replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start())));
  return initial_pose_mismatch(prepared, declared);
}

// A mass that rests at 0 under no force, read from another zero.
std::optional<data::Warning> warning_where_zero_is_at(double zero, double noise, data::Start start,
                                                      const std::vector<double>& first = {}) {
  data::Run run = run_at(-zero, 0.0, noise);
  run.start = start;
  std::ranges::copy(first, run.channels.front().values.begin());
  return warning_of({run});
}

TEST(FirstPoses, FarFromTheDeclaredRestAreNamedWithBothAngles) {
  const auto warning = warning_where_zero_is_at(0.35, 1e-3, data::Start::at_rest);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->run, "slide.csv");
  EXPECT_EQ(warning->text,
            "theta1_rad begins at -20.1 deg, where the declared model rests at 0 deg. If the angle is counted from its "
            "rest, add 20.1 deg to the record: 0 is a straight finger. If it is not, check the masses, lengths, "
            "magnets and gravity of the actuator file");
}

// A force that began half a second before the first picture has turned the finger by 0.5 rad since.
TEST(FirstPoses, OfAFingerThatMovesAlreadySayNothing) {
  data::Run run = run_at(0.5, 50.0);
  for (double& time : run.times) time += 0.5;
  run.input_times = {0.0, 0.01};
  run.inputs = {{0.0}, {50.0}};
  EXPECT_FALSE(warning_of({run}));
  run.inputs = {{0.0}, {0.0}};
  EXPECT_TRUE(warning_of({run}));
}

TEST(FirstPoses, NearItWithinTheNoiseOrFreeSayNothing) {
  EXPECT_FALSE(warning_where_zero_is_at(0.05, 1e-3, data::Start::at_rest));
  EXPECT_FALSE(warning_where_zero_is_at(0.35, 0.05, data::Start::at_rest));
  EXPECT_FALSE(warning_where_zero_is_at(0.35, 1e-3, data::Start::free));
}

// The first picture was misread and the finger is on its way in the third; or only the second was taken well.
TEST(FirstPoses, NeedThreeReadingsThatAgree) {
  EXPECT_FALSE(warning_where_zero_is_at(0.0, 1e-3, data::Start::at_rest, {0.17, 0.0, 0.12}));
  EXPECT_FALSE(warning_where_zero_is_at(0.0, 1e-3, data::Start::at_rest, {0.17, 0.01, -0.2}));
  const auto moved = warning_where_zero_is_at(0.0, 1e-3, data::Start::at_rest, {0.35, 0.3, 0.25});
  ASSERT_TRUE(moved);
  EXPECT_TRUE(moved->text.starts_with("theta1_rad begins at 14.3 deg")) << moved->text;
}

// A release begins where a current holds the finger: the stiffness may be off, and another run shows the zero.
TEST(FirstPoses, ThatACurrentHoldsSayLittleOfTheZero) {
  const double held = 0.8;  // rad
  const double torque = held * stiffness;
  EXPECT_FALSE(warning_of({run_at(1.2 * held, torque)}));
  EXPECT_TRUE(warning_of({run_at(1.5 * held, torque)}));
  EXPECT_TRUE(warning_of({run_at(1.5 * held, torque), run_at(0.5 * held, 0.0)}));
  EXPECT_FALSE(warning_of({run_at(1.5 * held, torque), run_at(0.01, 0.0)}));
}

}  // namespace
}  // namespace coilwright::measurement::records
