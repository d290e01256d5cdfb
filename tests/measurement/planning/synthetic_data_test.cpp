#include "coilwright/measurement/planning/synthetic_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/blocked_grasp.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/transient.hpp"
#include "degree.hpp"
#include "error_text.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Assembly;
using actuator::Design;
using actuator::Model;
using mechanics::JointVector;

const Assembly& finger() {
  static const Assembly assembly = [] {
    Design design;
    design.layout = actuator::layout_of(actuator::Configuration::B);
    return actuator::assemble_or_throw(design);
  }();
  return assembly;
}

replay::DeclaredModel finger_rig() {
  Design design;
  design.layout = actuator::layout_of(actuator::Configuration::B);
  return {.calibration = {},
          .build = [](std::span<const double>) { return finger().model.nominal_spec(); },
          .heat = actuator::heat_network(design, finger())};
}

// A point mass of 1 kg on 1 m.
replay::DeclaredModel pendulum() {
  return {.calibration = {}, .build = [](std::span<const double>) {
            const mechanics::Link link{.length = 1.0, .com_along = 1.0, .com_offset = 0.0, .mass = 1.0, .inertia = 0.0};
            return actuator::ModelSpec{.chain = mechanics::PlanarChain(std::span(&link, 1), 9.81),
                                       .hinges = {actuator::Hinge{}},
                                       .magnetics = {},
                                       .coils = 0,
                                       .tip = {}};
          }};
}

PlannedRun motion(const std::string& name, InputShape input, double duration = 0.5) {
  PlannedRun run{.plan = {.name = name, .kind = data::RunKind::transient, .drive = data::Drive::current},
                 .input = std::move(input),
                 .duration = duration,
                 .rate = 500.0};
  run.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
  return run;
}

const InputShape sine = SineShape{.amplitude = 0.5, .offset = 0.7, .frequency = 3.0};

Experiment one(PlannedRun run) {
  return {.name = "x", .instruments = {}, .runs = {std::move(run)}};
}

std::vector<double> values_of(const Experiment& experiment, std::uint64_t seed = 1, std::size_t run = 0) {
  return simulate_experiment(experiment, finger_rig(), {}, seed).at(run).channels.at(0).values;
}

actuator::Effect effect(std::string_view id, std::vector<double> values) {
  return {.kind = actuator::standard_effects().find(id), .values = std::move(values)};
}

TEST(SyntheticData, WithoutEffectAndNoiseAreTheSimulation) {
  const Model& model = finger().model;
  const auto input = simulation::sine_input(
      model, {.amplitude = 0.5, .offset = 0.7, .frequency = 3.0, .duration = 0.5, .interval = 1.0 / 500.0});
  const auto rest = simulation::find_equilibrium(model, input.currents.front(), JointVector::Zero(2));
  ASSERT_TRUE(rest.has_value());
  const auto states = simulation::simulate(model, input, {.angles = *rest, .rates = JointVector::Zero(2)});
  const std::vector<double> seen = values_of(one(motion("a.csv", sine)));
  ASSERT_EQ(seen.size(), states.size());
  // The twin integrates to 1e-6 a step instead of 1e-7: far below the 0.02 deg that a camera resolves.
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_NEAR(seen[i], states[i].angles.sum(), 1e-4 * degree) << i;
}

// What drives the finger are the samples themselves, also where they are few: six a period once passed as noise of a
// recorded input, were smoothed away, and the finger rested 4 degrees beside its first one.
TEST(SyntheticData, AreDrivenByAFastSineAsItIsSampled) {
  PlannedRun run = motion("a.csv", SineShape{.amplitude = 0.7, .offset = 0.7, .frequency = 10.0}, 1.0);
  run.rate = 60.0;
  const data::Run slow = simulate_experiment(one(run), finger_rig(), {}, 1).front();
  const Model& model = finger().model;
  simulation::ModelInput held;
  constexpr int parts = 20;  // of each interval between two samples
  for (std::size_t i = 0; i < slow.times.size(); ++i)
    for (int k = 0; k < parts; ++k) {
      held.times.push_back(slow.times[i] + k / (60.0 * parts));
      held.currents.push_back(model.all_coils(slow.inputs[i][0]));
    }
  const auto rest = simulation::find_equilibrium(model, held.currents.front(), JointVector::Zero(2));
  ASSERT_TRUE(rest.has_value());
  const auto states = simulation::simulate(model, held, {.angles = *rest, .rates = JointVector::Zero(2)});
  // As above: the twin integrates to 1e-6 a step.
  for (std::size_t i = 0; i < slow.times.size(); ++i)
    EXPECT_NEAR(slow.channels[0].values[i], states[parts * i].angles.sum(), 1e-4 * degree) << i;
}

TEST(SyntheticData, AreTheSameBitsForTheSameSeedOnly) {
  Experiment experiment = one(motion("a.csv", sine));
  experiment.instruments.angle = {.noise = 0.3 * degree, .resolution = 0.0};
  const std::vector<double> first = values_of(experiment, 1);
  EXPECT_EQ(values_of(experiment, 1), first);
  const std::vector<double> other = values_of(experiment, 2);
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NE(first[i], other[i]) << i;
  // A seed beyond 32 bits is another seed.
  EXPECT_NE(values_of(experiment, 1 + (std::uint64_t{1} << 32)), first);
}

TEST(SyntheticData, AnotherRunChangesNoneOfTheOthers) {
  Experiment experiment = one(motion("a.csv", sine));
  experiment.instruments.angle.noise = 0.3 * degree;
  const std::vector<double> alone = values_of(experiment);
  experiment.runs.push_back(motion("b.csv", sine));
  EXPECT_EQ(values_of(experiment), alone);
  EXPECT_NE(values_of(experiment, 1, 1), alone);
}

TEST(SyntheticData, HasWhiteGaussianNoiseOfTheGivenDeviation) {
  Experiment experiment = one(motion("a.csv", HoldShape{.level = 0.0, .from = 0.0, .until = 1.0}, 40.0));
  const double truth = values_of(experiment).front();
  experiment.instruments.angle.noise = 0.3 * degree;
  std::vector<double> noise = values_of(experiment);
  for (double& value : noise) value = (value - truth) / (0.3 * degree);
  const auto n = static_cast<double>(noise.size());
  ASSERT_EQ(noise.size(), 20001u);
  double sum = 0.0;
  double squares = 0.0;
  double fourth = 0.0;
  double next = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    sum += noise[i];
    squares += noise[i] * noise[i];
    fourth += std::pow(noise[i], 4);
    if (i > 0) next += noise[i] * noise[i - 1];
  }
  // Four standard errors of each, for unit Gaussian noise: 1 / n of the mean, 2 / n of the variance, 96 / n of the
  // fourth moment, 1 / n of the correlation from sample to sample.
  EXPECT_NEAR(sum / n, 0.0, 4.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0, 4.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3.0, 4.0 * std::sqrt(96.0 / n));
  EXPECT_NEAR(next / n, 0.0, 4.0 / std::sqrt(n));
}

TEST(SyntheticData, AreTheNearestMultiplesOfTheResolution) {
  Experiment experiment = one(motion("a.csv", sine));
  const std::vector<double> exact = values_of(experiment);
  const double resolution = 0.5 * degree;
  experiment.instruments.angle.resolution = resolution;
  const std::vector<double> read = values_of(experiment);
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_NEAR(read[i] / resolution, std::round(read[i] / resolution), 1e-9) << i;
    EXPECT_LE(std::abs(read[i] - exact[i]), 0.5 * resolution * (1.0 + 1e-9)) << i;
  }
}

TEST(SyntheticData, ContainAnEffectOfTheCamera) {
  const Experiment experiment = one(motion("a.csv", sine));
  const std::vector<double> plain = values_of(experiment);
  const std::vector hidden = {effect("angle_offset", {1.5 * degree})};
  const auto shown = simulate_experiment(experiment, finger_rig(), hidden, 1)[0].channels[0].values;
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(shown[i] - plain[i], 1.5 * degree, 1e-12) << i;
}

TEST(SyntheticData, ReleasesAPendulumFromItsStartAngle) {
  PlannedRun run = motion("a.csv", StepShape{.before = 0.0, .after = 0.0, .at = 0.0}, 2.0);
  run.plan.drive = data::Drive::torque;
  run.plan.start = data::Start::free;
  run.start_angles = {0.5 * degree};
  const auto out = simulate_experiment(one(run), pendulum(), {}, 1)[0];
  EXPECT_EQ(out.start, data::Start::free);
  EXPECT_EQ(out.inputs.front(), std::vector<double>{0.0});
  // At half a degree the pendulum is linear to angle^2 / 16, 5e-6 of its period.
  for (std::size_t i = 0; i < out.times.size(); ++i)
    EXPECT_NEAR(out.channels[0].values[i], 0.5 * degree * std::cos(std::sqrt(9.81) * out.times[i]), 1e-4 * 0.5 * degree)
        << i;
}

TEST(SyntheticData, DrivesOneCoilAlone) {
  PlannedRun run = motion("a.csv", StepShape{.before = 0.0, .after = 1.0, .at = 0.1});
  run.only = 1;
  const auto out = simulate_experiment(one(run), finger_rig(), {}, 1)[0];
  EXPECT_EQ(out.inputs.front(), (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(out.inputs.back(), (std::vector<double>{0.0, 1.0}));
  run.only.reset();
  const auto both = simulate_experiment(one(run), finger_rig(), {}, 1)[0];
  EXPECT_EQ(both.inputs.back(), std::vector<double>{1.0});
  EXPECT_GT(both.channels[0].values.back(), out.channels[0].values.back() + degree);
}

TEST(SyntheticData, HoldsTheRowsOfATableBetweenItsSamples) {
  PlannedRun run = motion("a.csv", TableShape{.times = {2.0, 2.1, 2.3}, .rows = {{0.1}, {0.2}, {0.3}}}, 0.4);
  run.rate = 20.0;
  const auto out = simulate_experiment(one(run), finger_rig(), {}, 1)[0];
  EXPECT_EQ(out.inputs,
            (std::vector<std::vector<double>>{{0.1}, {0.1}, {0.2}, {0.2}, {0.2}, {0.2}, {0.3}, {0.3}, {0.3}}));
}

TEST(SyntheticData, IncludesTheBenches) {
  const Model& model = finger().model;
  PlannedRun torque{.plan = {.name = "torque.csv", .kind = data::RunKind::static_torque}};
  torque.plan.angles = {10 * degree, 40 * degree};
  torque.plan.inputs = {{1.4}, {0.7}};
  torque.plan.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
  PlannedRun stiffness{.plan = {.name = "stiffness.csv", .kind = data::RunKind::joint_stiffness}};
  stiffness.plan.angles = {10 * degree, 40 * degree};
  stiffness.plan.channels = torque.plan.channels;
  PlannedRun force{.plan = {.name = "force.csv", .kind = data::RunKind::blocked_force}};
  force.plan.inputs = {{1.4}};
  force.plan.channels = {{.name = "force_N", .kind = data::ChannelKind::force}};
  const auto runs =
      simulate_experiment({.name = "x", .instruments = {}, .runs = {torque, stiffness, force}}, finger_rig(), {}, 1);
  const auto& pair = model.magnetics().hinge_pairs().front();
  EXPECT_EQ(runs[0].channels[0].values.size(), 2u);
  EXPECT_NEAR(runs[0].channels[0].values[0], 1.4 * pair.sense * pair.torque_per_ampere->value(10 * degree), 1e-6);
  EXPECT_NEAR(runs[1].channels[0].values[1], model.hinges()[0].stiffness * 40 * degree, 1e-12);
  EXPECT_EQ(runs[2].channels[0].values[0], simulation::blocked_grasp(model, model.all_coils(1.4))->force);
}

TEST(SyntheticData, WarmsACoilFromAmbient) {
  PlannedRun heat = motion("heat.csv", HoldShape{.level = 1.0, .from = 0.0, .until = 1e5}, 7200.0);
  heat.plan.kind = data::RunKind::temperature;
  heat.rate = 1.0 / 60.0;
  heat.plan.channels = {{.name = "temperature_degC", .kind = data::ChannelKind::temperature}};
  const auto out = simulate_experiment(one(heat), finger_rig(), {}, 1)[0];
  EXPECT_NEAR(out.channels[0].values.front(), 25.0, 1e-9);
  EXPECT_TRUE(std::ranges::is_sorted(out.channels[0].values));
  EXPECT_GT(out.channels[0].values.back(), 60.0);
}

TEST(SyntheticData, NamesTheRunThatDoesNotFitTheRig) {
  const auto refusal = [](const PlannedRun& run, const replay::DeclaredModel& rig) {
    return error_text([&] { (void)simulate_experiment(one(run), rig, {}, 1); });
  };
  PlannedRun run = motion("a.csv", sine);
  EXPECT_EQ(refusal(run, pendulum()), "a.csv: drives coils, and the model has none");
  run.only = 2;
  EXPECT_EQ(refusal(run, finger_rig()), "a.csv: drives coil 3, and the model has 2");
  run.only.reset();
  run.start_angles = {0.1};
  EXPECT_EQ(refusal(run, finger_rig()), "a.csv: needs a start angle for each of the 2 joints; got 1");
  run.start_angles.clear();
  run.plan.channels = {{.name = "theta3_deg", .kind = data::ChannelKind::joint_angle, .joint = 2}};
  EXPECT_EQ(refusal(run, finger_rig()), "a.csv: theta3_deg is of joint 3, and the model has 2");
}

// Before the first of them is simulated.
TEST(SyntheticData, RefusesMoreSamplesThanItCanHold) {
  const PlannedRun run = motion("a.csv", sine, 1200.0);  // 600,000 samples
  const Experiment twice{.name = "x", .instruments = {}, .runs = {run, run}};
  EXPECT_EQ(error_text([&] { (void)simulate_experiment(twice, finger_rig(), {}, 1); }),
            "the runs must have at most 1000000 samples together; got 1200000: shorten duration_s, or lower "
            "sampling_rate_Hz");
  PlannedRun exposed = motion("b.csv", sine, 200.0);  // five looks at each of 100,000 samples, and ten between two
  exposed.plan.clock.exposure = 1e-3;
  EXPECT_EQ(error_text([&] { (void)simulate_experiment(one(exposed), finger_rig(), {}, 1); }),
            "b.csv: must be simulated at 1000000 times at most (a sample is one; with an exposure, two clocks or an "
            "input between samples some 10 to 15); got 1500000: shorten duration_s, or lower sampling_rate_Hz");
}

}  // namespace
}  // namespace coilwright::measurement::planning
