#include "measurement/planning/linearised_records.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "degree.hpp"
#include "measurement/fit/fit.hpp"
#include "measurement/planning/prototype_finger.hpp"
#include "measurement/replay/recorded_noise.hpp"

namespace coilwright::measurement::planning {
namespace {

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
  ASSERT_TRUE(nothing);
  EXPECT_LT(nothing->norm(), 1e-3);
}

// Two steps that ring for long: a heavier tip rings more slowly, and so do declared numbers that are off.
Experiment ringing() {
  Experiment out{.name = "ringing", .instruments = {}, .runs = {}};
  for (const double after : {0.7, 1.4}) {
    PlannedRun step{.plan = {.name = after > 1.0 ? "strong.csv" : "weak.csv",
                             .kind = data::RunKind::transient,
                             .drive = data::Drive::current},
                    .input = StepShape{.after = after, .at = 0.1},
                    .duration = 1.5,
                    .rate = 200.0};
    step.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
    out.runs.push_back(step);
  }
  out.instruments.angle.noise = 0.3 * degree;
  return out;
}

TEST(LinearisedRecords, FitDeclaredNumbersToAChangeAsAFitOfItsRecordsDoes) {
  const actuator::EffectKind* kind = actuator::standard_effects().find("added_mass");
  const std::vector<actuator::Effect> effects{{.kind = kind, .values = {3e-3}}};
  const LinearisedRecords records(ringing(), finger().model, 1);
  const auto change = records.change_by(effects.front());
  ASSERT_TRUE(change);
  const double along_tangents = records.beyond_declared(*change).norm();
  const double refitted = records.length_after_refit(*change);
  EXPECT_LT(refitted, 0.8 * along_tangents);

  // Ceres, with derivatives of its own at each step, on records with the effect.
  const std::vector<data::Run> recorded = simulate_experiment(ringing(), finger().model, effects, 1);
  const fit::Hypothesis declared(finger().model, {});
  const fit::Hypothesis true_one(finger().model, effects);
  std::vector<replay::PreparedRun> runs;
  for (const data::Run& run : recorded) {
    const actuator::Model model = declared.model_at(declared.start());
    runs.push_back(replay::prepare_run(run, finger().model, model));
    replay::give_recorded_noise(runs.back(), {}, recorded, model);
  }
  const auto fitted = fit::fit({.hypothesis = &declared, .runs = runs, .start = declared.start()});
  const auto truth = fit::evaluate_at({.hypothesis = &true_one, .runs = runs, .start = true_one.start()});
  ASSERT_TRUE(fitted && truth);
  // What the fit leaves more than the truth does: the square of the length, but for the noise along it and what the
  // declared numbers take from the noise.
  const double square = fitted->objective() - truth->objective();
  EXPECT_NEAR(square, refitted * refitted, 4.0 * refitted + 20.0);
  EXPECT_GT(along_tangents * along_tangents - square, 4.0 * along_tangents);
}

}  // namespace
}  // namespace coilwright::measurement::planning
