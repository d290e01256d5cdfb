#include "measurement/planning/informative_experiment.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "degree.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Design;
using actuator::Effect;
using testing::AnyOf;

Effect effect(const char* id, std::vector<double> values) {
  return {.kind = actuator::standard_effects().find(id), .values = std::move(values)};
}

// The paper's finger, recorded in a step of 1.4 A by a camera of that noise.
struct Rig {
  explicit Rig(actuator::ContactChoice faces = actuator::ContactChoice::walls, double noise = 0.3 * degree) {
    Design design;
    design.layout = actuator::layout_of(actuator::Configuration::B);
    design.choices.faces = faces;
    const actuator::ModelSpec spec = actuator::assemble_or_throw(design).model.nominal_spec();
    declared.build = [spec](std::span<const double>) { return spec; };
    run = {.name = "step.csv",
           .kind = data::RunKind::transient,
           .drive = data::Drive::current,
           .sigma = noise,
           .channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}}};
    for (int i = 0; i < 350; ++i) {
      run.times.push_back(0.002 * i);
      run.inputs.push_back({i < 25 ? 0.0 : 1.4});
      run.channels.front().values.push_back(0.0);
    }
    const fit::Hypothesis plain(declared, {});
    runs.push_back(replay::prepare_run(run, declared, plain.model_at(plain.start())));
  }

  [[nodiscard]] identification::FittedHypothesis fitted(std::vector<Effect> effects) const {
    fit::Hypothesis hypothesis(declared, std::move(effects));
    fit::Fit fit{.values = hypothesis.start()};
    return {.hypothesis = std::move(hypothesis), .fit = std::move(fit)};
  }

  // Explanations of the same probability, whose numbers are known to a share of them.
  [[nodiscard]] std::optional<NextExperiment> between(const Effect& chosen, const std::vector<Effect>& rivals,
                                                      double known_to = 0.0) const {
    identification::Attribution found{.before = fitted({}), .after = fitted({chosen})};
    const auto add = [&](const identification::FittedHypothesis& each) {
      const Eigen::VectorXd& values = each.fit.values;
      found.posterior.hypotheses.push_back({.probability = 1.0 / (1.0 + static_cast<double>(rivals.size()))});
      found.weighed.push_back({.values = values, .covariance = (known_to * values).cwiseAbs2().asDiagonal()});
    };
    add(found.after);
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      found.rivals.push_back(fitted({rivals[i]}));
      found.answer.rivals.push_back(i + 1);
      add(found.rivals.back());
    }
    return informative_experiment(runs, found);
  }

  replay::DeclaredModel declared;
  data::Run run;
  std::vector<replay::PreparedRun> runs;
};

TEST(InformativeExperiment, IsNoneWithoutRivals) {
  EXPECT_FALSE(Rig().between(effect("coil_heating", {0.1, 10.0, 0.0}), {}).has_value());
}

TEST(InformativeExperiment, IsNoneIfRivalsPredictTheSame) {
  EXPECT_FALSE(Rig().between(effect("force_gain", {1.0 + 1e-6}), {effect("force_gain", {1.0})}).has_value());
}

TEST(InformativeExperiment, HoldsTheCoilsHotForTwoKindsOfHeat) {
  const auto next =
      Rig().between(effect("coil_heating", {0.05, 5.0, 0.0}), {effect("magnet_heating", {0.05, 30.0, 0.0})});
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->kind, "hot_hold");
  EXPECT_LT(next->remaining_bits, 0.5);
}

TEST(InformativeExperiment, MovesTheFingerFarOrTurnsATorqueRoundIfGravityIsInDoubt) {
  // Joints that may close a little: walls would hold them where an experiment turns the torque round.
  const Rig rig(actuator::ContactChoice::hard_parts);
  const auto next = rig.between(effect("base_tilt", {3.0 * degree}), {effect("angle_offset", {-1.0 * degree})});
  ASSERT_TRUE(next.has_value());
  EXPECT_THAT(next->kind, AnyOf("turned_base", "reversed_step", "chirp"));
  EXPECT_LT(next->remaining_bits, 0.5);
  EXPECT_FALSE(next->why.empty());
  EXPECT_FALSE(next->input.empty());
}

TEST(InformativeExperiment, IsAnExperimentThatEndsWithTheProposedRunTwice) {
  const Rig rig(actuator::ContactChoice::hard_parts);
  const auto next = rig.between(effect("base_tilt", {3.0 * degree}), {effect("angle_offset", {-1.0 * degree})});
  ASSERT_TRUE(next.has_value());
  const std::vector<PlannedRun>& runs = next->experiment.runs;
  ASSERT_EQ(runs.size(), 4u);  // the step that was recorded, the camera at rest, the proposal twice
  EXPECT_EQ(runs[0].plan.name, "step.csv");
  EXPECT_EQ(std::get<StepShape>(runs[0].input).after, 1.4);
  EXPECT_EQ(runs[1].plan.kind, data::RunKind::still);
  EXPECT_EQ(runs[2].plan.name, "next_" + next->kind + ".csv");
  EXPECT_EQ(runs[3].plan.name, "next_" + next->kind + "_2.csv");
  EXPECT_EQ(runs[2].plan.rig, runs[3].plan.rig);
  EXPECT_DOUBLE_EQ(runs[2].rate, 500.0);
  EXPECT_DOUBLE_EQ(next->experiment.instruments.angle.noise, 0.3 * degree);
}

TEST(InformativeExperiment, TellsWhatEachExplanationExpectsOfTheProposedRun) {
  const Rig rig(actuator::ContactChoice::hard_parts);
  const auto next = rig.between(effect("base_tilt", {0.06 * degree}), {effect("angle_offset", {-0.02 * degree})});
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->explanations, (std::vector<std::vector<std::string>>{{"base_tilt"}, {"angle_offset"}}));
  ASSERT_EQ(next->expected.size(), 1u);
  const ExpectedReading& angle = next->expected.front();
  EXPECT_EQ(angle.run, "next_" + next->kind + ".csv");
  EXPECT_EQ(angle.channel, "bending_angle_deg");
  EXPECT_DOUBLE_EQ(angle.noise, 0.3 * degree);
  ASSERT_EQ(angle.values.size(), 2u);
  ASSERT_EQ(angle.values[0].size(), angle.at.size());
  ASSERT_EQ(angle.values[1].size(), angle.at.size());
  // What is told of each sample is what the bits were worked out from.
  double squares = 0.0;
  for (std::size_t i = 0; i < angle.at.size(); ++i)
    squares += std::pow((angle.values[0][i] - angle.values[1][i]) / angle.noise, 2);
  EXPECT_NEAR(next->remaining_bits, std::log2(1.0 + std::exp(-squares / 8.0)), 1e-9);
  EXPECT_GT(next->remaining_bits, 0.1);
}

TEST(InformativeExperiment, TellsWhatATorqueBenchWouldRead) {
  // A camera so coarse that no motion tells as much as a bench does.
  const Rig rig(actuator::ContactChoice::walls, 20.0 * degree);
  const auto next = rig.between(effect("stiffness_hardening", {0.1}), {effect("force_gain", {0.9})});
  ASSERT_TRUE(next.has_value());
  ASSERT_EQ(next->kind, "bench_torque");
  ASSERT_EQ(next->expected.size(), 2u);
  for (const ExpectedReading& torque : next->expected) {
    EXPECT_EQ(torque.kind, data::ChannelKind::torque);
    EXPECT_EQ(torque.at.size(), 17u);
    EXPECT_NEAR(torque.at.back(), 80.0 * degree, 1e-12);
  }
}

TEST(InformativeExperiment, IsFastIfLagAndDelayAreInDoubt) {
  const auto next = Rig().between(effect("coil_lag", {0.01}), {effect("measurement_delay", {0.01})});
  ASSERT_TRUE(next.has_value());
  EXPECT_THAT(next->kind, AnyOf("step", "fast_sine", "chirp", "release", "reversed_step"));
}

// Three that are alike have log2 3 bits open; which of the two gains it is no run can tell.
TEST(InformativeExperiment, TellsWhatCanBeToldWhereTwoExplanationsAreOne) {
  const auto next =
      Rig().between(effect("coil_lag", {0.01}), {effect("force_gain", {1.1}), effect("force_gain", {1.1 + 1e-12})});
  ASSERT_TRUE(next.has_value());
  EXPECT_NEAR(next->open_bits, std::log2(3.0), 1e-12);
  EXPECT_NEAR(next->remaining_bits, 2.0 / 3.0, 2e-3);
}

// A gain that is off by half a per cent is plain where it is known, and can hardly be told where half a per cent is
// what the records know it to: of two normal numbers one deviation apart 0.91 bits stay open.
TEST(InformativeExperiment, CountsWhatNumbersLeaveOpen) {
  const Effect one = effect("force_gain", {1.005});
  const std::vector<Effect> other = {effect("force_gain", {1.0})};
  EXPECT_LT(Rig().between(one, other)->remaining_bits, 0.1);
  EXPECT_NEAR(Rig().between(one, other, 0.005)->remaining_bits, 0.91, 0.1);
}

}  // namespace
}  // namespace coilwright::measurement::planning
