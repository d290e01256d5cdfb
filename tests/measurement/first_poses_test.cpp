#include "measurement/first_poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "measurement/fit/hypothesis.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

// A mass that rests at 0 under no force, read from another zero.
std::optional<data::Warning> warning_where_zero_is_at(double zero, double noise, data::Start start,
                                                      const std::vector<double>& first = {}) {
  replay::DeclaredModel declared = slide(true_mass, 0.1);
  declared.build = [](std::span<const double> values) {
    actuator::ModelSpec spec = slide(true_mass, 0.1).build(values);
    spec.hinges.front().stiffness = 100.0;
    return spec;
  };
  data::Run run = slide_run(50, {}, no_error);
  run.start = start;
  run.sigma = noise;
  for (auto& row : run.inputs) row = {0.0};
  for (double& value : run.channels.front().values) value = -zero;
  std::ranges::copy(first, run.channels.front().values.begin());
  const fit::Hypothesis hypothesis(declared, {});
  std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  return far_first_pose(runs, declared);
}

TEST(FirstPoses, FarFromTheDeclaredRestAreNamedWithBothAngles) {
  const auto warning = warning_where_zero_is_at(0.35, 1e-3, data::Start::at_rest);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->run, "slide.csv");
  EXPECT_EQ(warning->text,
            "theta1_rad begins at -20.1 deg, where the declared model rests at 0 deg. If the angle is counted from its "
            "rest, add 20.1 deg to the record: 0 is a straight finger, and no effect moves the zero of a sensor by "
            "more than 10 deg");
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

}  // namespace
}  // namespace coilwright::measurement
