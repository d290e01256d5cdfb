// A motor's torque is known worse than its angle: records in which that is declared are judged by what it allows.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"

namespace coilwright::measurement {
namespace {

constexpr double friction = 0.05;      // N m
constexpr double torque_sigma = 0.04;  // N m, a tenth of what drives

// 0.5 kg at 0.2 m, its damping unknown.
replay::DeclaredModel pendulum() {
  return {.calibration = {{.key = "damping",
                           .declared = 0.01,
                           .lower = 0.0,
                           .upper = std::numeric_limits<double>::infinity(),
                           .scale = 0.01}},
          .build = [](std::span<const double> values) {
            const mechanics::Link link{
                .length = 0.3, .com_along = 0.2, .com_offset = 0.0, .mass = 0.5, .inertia = 0.005};
            return actuator::ModelSpec{.chain = mechanics::PlanarChain(std::span(&link, 1)),
                                       .hinges = {actuator::Hinge{.damping = values[0]}},
                                       .magnetics = {},
                                       .coils = 0,
                                       .tip = {}};
          }};
}

planning::Experiment motor_runs() {
  planning::Experiment out{.name = "motor", .instruments = {}, .runs = {}};
  const auto add = [&](const char* name, planning::InputShape input) {
    planning::PlannedRun run{.plan = {.name = name,
                                      .kind = data::RunKind::transient,
                                      .drive = data::Drive::torque,
                                      .start = data::Start::free,
                                      .input_uncertainty = {.sigma = {torque_sigma}}},
                             .input = std::move(input),
                             .duration = 3.0,
                             .rate = 250.0};
    run.plan.channels = {{.name = "theta1_deg", .kind = data::ChannelKind::joint_angle}};
    out.runs.push_back(std::move(run));
  };
  add("slow.csv", planning::SineShape{.amplitude = 0.6, .frequency = 0.8});
  add("fast.csv", planning::SineShape{.amplitude = 0.3, .frequency = 1.7});
  add("step.csv", planning::StepShape{.after = 0.5, .at = 0.5});
  out.instruments.angle.noise = 3e-4;
  return out;
}

// The same records with the torque declared to be as good as it is, or not.
Diagnosis diagnosed(std::span<const actuator::Effect> hidden, bool declared, std::uint64_t seed) {
  const replay::DeclaredModel model = pendulum();
  data::Dataset data;
  data.name = "motor";
  data.fit = planning::simulate_experiment(motor_runs(), model, hidden, seed);
  if (!declared)
    for (data::Run& run : data.fit) run.input_uncertainty = {};
  return diagnose(data, model, {.threads = 2});
}

TEST(InputSigma, NamesAFrictionThatANoisyTorqueHides) {
  const actuator::Effect hidden{.kind = actuator::standard_effects().find("dry_friction"), .values = {friction}};
  const Diagnosis found = diagnosed(std::span(&hidden, 1), true, 1);
  EXPECT_EQ(found.verdict, Verdict::explained);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects.front().kind->id(), "dry_friction");
  const identification::Estimate& torque = found.effects.front().parameters.front();
  EXPECT_LT(torque.lower, friction);
  EXPECT_GT(torque.upper, friction);
  // Wider than against the noise of the encoder alone, by which 0.05 N m would be known to a thousandth.
  EXPECT_GT(torque.upper - torque.lower, 0.01 * friction);
}

TEST(InputSigma, NamesNothingWhereOnlyTheTorqueIsNoisy) {
  const Diagnosis found = diagnosed({}, true, 2);
  EXPECT_EQ(found.verdict, Verdict::no_missing_effect);
  EXPECT_TRUE(found.effects.empty());
  const Errors& errors = found.fit_errors.front().before;
  // What is left in degrees is what the errors of the torque leave.
  EXPECT_LT(errors.rmse, 1.3 * found.fit_errors.front().noise_floor_rmse);
}

}  // namespace
}  // namespace coilwright::measurement
