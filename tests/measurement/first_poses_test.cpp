#include "measurement/first_poses.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "measurement/fit/hypothesis.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

// A mass that rests at 0 under no force, read from another zero.
std::vector<data::Warning> warnings_where_zero_is_at(double zero, double noise, data::Start start) {
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
  const fit::Hypothesis hypothesis(declared, {});
  std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  std::vector<data::Warning> out = warnings_of_first_poses(runs, declared);
  return out;
}

TEST(FirstPoses, FarFromTheDeclaredRestAreNamedWithBothAngles) {
  const auto warnings = warnings_where_zero_is_at(0.35, 1e-3, data::Start::at_rest);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings.front().run, "slide.csv");
  EXPECT_EQ(
      warnings.front().text,
      "theta1_rad begins at -20.1 deg, where the declared model rests at 0 deg. If the angle is counted from its "
      "rest, add the difference to the record: 0 is a straight finger, and no effect moves the zero of a sensor by "
      "more than 10 deg");
}

TEST(FirstPoses, NearItWithinTheNoiseOrFreeSayNothing) {
  EXPECT_TRUE(warnings_where_zero_is_at(0.05, 1e-3, data::Start::at_rest).empty());
  EXPECT_TRUE(warnings_where_zero_is_at(0.35, 0.05, data::Start::at_rest).empty());
  EXPECT_TRUE(warnings_where_zero_is_at(0.35, 1e-3, data::Start::free).empty());
}

}  // namespace
}  // namespace coilwright::measurement
