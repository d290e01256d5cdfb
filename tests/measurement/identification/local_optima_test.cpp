// A loose magnet bounces: the cost of its gap has one narrow valley beside the other, and where a fit of a laboratory's
// record began decided it (8.70 deg, 8.70 to 8.71, where 10 was true).
#include "measurement/identification/local_optima.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "measurement/declared_finger.hpp"
#include "measurement/identification/intervals.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

// A step and a release.
planning::Experiment there_and_back() {
  planning::Experiment out{.name = "there and back", .instruments = {}, .runs = {}};
  const auto add = [&](const char* name, planning::StepShape input) {
    planning::PlannedRun run{.plan = {.name = name, .kind = data::RunKind::transient, .drive = data::Drive::current},
                             .input = input,
                             .duration = 1.2,
                             .rate = 120.0};
    run.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
    out.runs.push_back(std::move(run));
  };
  add("step.csv", {.after = 1.0, .at = 0.1});
  add("release.csv", {.before = 1.4, .after = 0.0, .at = 0.1});
  out.instruments.angle.noise = 0.2 * degree;
  return out;
}

// Records of a finger with one effect, and a fit of the same effect that began at another strength.
struct Fitted {
  Fitted(const char* id, double truth, double start) {
    const actuator::EffectKind* kind = actuator::standard_effects().find(id);
    const actuator::Effect hidden{.kind = kind, .values = {truth}};
    records = planning::simulate_experiment(there_and_back(), finger().model, std::span(&hidden, 1), 5);
    const fit::Hypothesis plain(finger().model, {});
    for (const data::Run& run : records)
      runs.push_back(replay::prepare_run(run, finger().model, plain.model_at(plain.start())));
    fit::Hypothesis hypothesis(finger().model, {{.kind = kind, .values = {start}}});
    const Eigen::VectorXd from = hypothesis.start();
    found = fit_exactly(runs, {.hypothesis = std::move(hypothesis), .start = from});
  }
  [[nodiscard]] Eigen::Index number() const { return found->hypothesis.parameters_of(0).first; }
  std::vector<data::Run> records;
  std::vector<replay::PreparedRun> runs;
  std::optional<FittedHypothesis> found;
};

TEST(LocalOptima, OfALooseMagnetAreInTheIntervalOfItsGap) {
  constexpr double gap = 8.0 * degree;
  const Fitted loose("backlash", gap, 6.5 * degree);
  const EstimatedHypothesis all = estimated(loose.runs, *loose.found, 1.0);
  const Estimate& estimate = all.estimates[static_cast<std::size_t>(loose.number())];
  EXPECT_LT(all.fitted.fit.objective(), loose.found->fit.objective());
  EXPECT_TRUE(estimate.has_many_optima);
  EXPECT_LT(estimate.lower, gap);
  EXPECT_GT(estimate.upper, gap);
}

// A late camera has one valley, from which no start leads elsewhere.
TEST(LocalOptima, OfADelayAreOne) {
  constexpr double delay = 30e-3;
  const Fitted late("measurement_delay", delay, 20e-3);
  ASSERT_TRUE(late.found);
  const LocalOptima along = local_optima_along(late.runs, *late.found, late.number(), 0.0, 1.0);
  EXPECT_FALSE(along.ends);
  EXPECT_FALSE(along.better);
}

TEST(LocalOptima, AreLookedForWhereAnEndIsNearerThanHalfAPercent) {
  const Estimate gap{.key = "gap_deg", .value = 0.1, .lower = 0.0996, .upper = 0.11};
  EXPECT_TRUE(is_suspiciously_narrow(gap, 0.0));
  EXPECT_FALSE(is_suspiciously_narrow({.key = "gap_deg", .value = 0.1, .lower = 0.0994, .upper = 0.11}, 0.0));
  // A scale of 1.02 is 0.02 from none.
  EXPECT_FALSE(is_suspiciously_narrow({.key = "scale", .value = 1.02, .lower = 1.0195, .upper = 1.0205}, 1.0));
}

}  // namespace
}  // namespace coilwright::measurement::identification
