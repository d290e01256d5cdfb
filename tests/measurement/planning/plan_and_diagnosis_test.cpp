// What a plan promises, checked against diagnoses of twins. Every figure is a count.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/planning/experiment_plan.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "degree.hpp"
#include "measurement/identification/effect_strength.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Effect;
using actuator::EffectCatalogue;

constexpr std::uint64_t seeds = 5;

// A short catalogue: a diagnosis of a set takes seconds.
const EffectCatalogue& few_effects() {
  static const EffectCatalogue few = [] {
    std::vector<const actuator::EffectKind*> kinds;
    for (const char* id : {"dry_friction", "quadratic_drag", "base_tilt", "measurement_delay", "angle_offset"})
      kinds.push_back(actuator::standard_effects().find(id));
    return EffectCatalogue(std::move(kinds));
  }();
  return few;
}

PlannedRun motion(std::string name, InputShape input) {
  PlannedRun run{.plan = {.name = std::move(name), .kind = data::RunKind::transient, .drive = data::Drive::current},
                 .input = std::move(input),
                 .duration = 1.0,
                 .rate = 240.0};
  run.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
  return run;
}

Experiment short_experiment() {
  Experiment out{.name = "short",
                 .runs = {motion("step.csv", StepShape{.after = 1.4, .at = 0.1}),
                          motion("small_step.csv", StepShape{.after = 0.7, .at = 0.1}),
                          motion("release.csv", StepShape{.before = 1.0, .at = 0.1})}};
  // Each twice: a diagnosis credits an effect only if it helps in runs that were left out of the fit.
  const std::vector<PlannedRun> once = out.runs;
  for (PlannedRun again : once) {
    again.plan.name = "again_" + again.plan.name;
    out.runs.push_back(std::move(again));
  }
  out.instruments.angle.noise = 0.3 * degree;
  return out;
}

// With the calibration and the tolerances of a set that says nothing of them.
const formats::DeclaredActuator& finger() {
  static const std::vector<std::string> calibrated{"joint_stiffness", "joint_damping"};
  static const formats::DeclaredActuator declared =
      formats::parse_declared_actuator(R"({"format": "actuator/1", "configuration": "B"})", "finger.json",
                                       {.names = calibrated, .file = "dataset.json", .tolerances = {}});
  return declared;
}

const ExperimentPlan& plan() {
  static const ExperimentPlan planned =
      plan_experiment(short_experiment(), finger().model, {.threads = 2, .effects = few_effects()});
  return planned;
}

bool named_or_in_the_set(const Diagnosis& diagnosis, const actuator::EffectKind* kind) {
  if (std::ranges::count(diagnosis.effects, kind, &AddedEffect::kind) > 0) return true;
  return std::ranges::any_of(diagnosis.indistinguishable, [&](const std::vector<const actuator::EffectKind*>& set) {
    return std::ranges::count(set, kind) > 0;
  });
}

int times_found(const VisibleEffect& planned, double strength) {
  int found = 0;
  const Effect hidden = identification::scaled_from_absent(planned.effect, strength);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    data::Dataset data;
    data.name = "twin";
    data.fit = simulate_experiment(short_experiment(), finger().model, std::span(&hidden, 1), seed);
    const Diagnosis diagnosis = diagnose(data, finger().model, {.threads = 2, .seed = 1, .effects = few_effects()});
    found += named_or_in_the_set(diagnosis, hidden.kind) ? 1 : 0;
  }
  return found;
}

class PlanAndDiagnosis : public testing::TestWithParam<std::string> {};

TEST_P(PlanAndDiagnosis, AgreeOnWhatCanBeFound) {
  const auto planned = std::ranges::find_if(
      plan().effects, [](const VisibleEffect& each) { return each.effect.kind->id() == GetParam(); });
  ASSERT_NE(planned, plan().effects.end());
  ASSERT_TRUE(planned->visible);
  const int weak = times_found(*planned, 0.4);
  const int strong = times_found(*planned, 2.0);
  std::printf("%s: found %d of %d at 0.4, %d of %d at 2 times the planned strength\n", GetParam().c_str(), weak,
              static_cast<int>(seeds), strong, static_cast<int>(seeds));
  EXPECT_LE(weak, 1);
  EXPECT_GE(strong, 4);
}

INSTANTIATE_TEST_SUITE_P(Effects, PlanAndDiagnosis,
                         testing::Values("dry_friction", "quadratic_drag", "base_tilt", "measurement_delay"));

}  // namespace
}  // namespace coilwright::measurement::planning
