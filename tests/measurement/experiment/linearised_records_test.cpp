#include "measurement/experiment/linearised_records.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"

namespace coilwright::measurement::experiment {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

const formats::DeclaredActuator& finger() {
  static const std::vector<std::string> calibrated{"joint_stiffness", "joint_damping"};
  static const formats::DeclaredActuator declared =
      formats::parse_declared_actuator(R"({"format": "actuator/1", "configuration": "B"})", "finger.json",
                                       {.names = calibrated, .file = "dataset.json", .tolerances = {}});
  return declared;
}

// Steps before a camera so slow that what rings between two pictures passes as noise.
Experiment slow_camera() {
  PlannedRun step{.plan = {.name = "step.csv", .kind = data::RunKind::transient, .drive = data::Drive::current},
                  .input = StepShape{.after = 1.4, .at = 0.1},
                  .duration = 2.0,
                  .rate = 30.0};
  step.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
  PlannedRun release = step;
  release.plan.name = "release.csv";
  release.input = StepShape{.before = 1.4, .after = 0.0, .at = 0.1};
  Experiment out{.name = "slow", .instruments = {}, .runs = {step, release}};
  out.instruments.angle.noise = 0.1 * degree;
  return out;
}

TEST(LinearisedRecords, TakeResidualsOverTheNoiseThatTheyEndWith) {
  const LinearisedRecords records(slow_camera(), finger().model, 1);
  // The first estimate counted motion as noise; what the model leaves told it better.
  int anew = 0;
  for (const replay::PreparedRun& run : records.runs())
    anew += run.noise.front().source.starts_with("of what the recalibrated model leaves") ? 1 : 0;
  EXPECT_GT(anew, 0);
  // 0.1 degrees as it was simulated; chi-square over 61 samples has a standard deviation of 0.18.
  for (const fit::RunFit& run : records.base().fit.runs)
    EXPECT_NEAR(run.residuals.squaredNorm() / static_cast<double>(run.residuals.size()), 1.0, 0.6);
  // So that what is absent changes nothing.
  const actuator::EffectKind* kind = actuator::standard_effects().find("measurement_delay");
  const auto nothing = records.change_by({.kind = kind, .values = {0.0}});
  ASSERT_TRUE(nothing.value);
  EXPECT_LT(nothing.value->norm(), 1e-3);
}

}  // namespace
}  // namespace coilwright::measurement::experiment
