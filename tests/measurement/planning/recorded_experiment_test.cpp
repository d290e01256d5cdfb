#include "measurement/planning/recorded_experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "degree.hpp"
#include "measurement/planning/candidate_runs.hpp"
#include "measurement/planning/linearised_records.hpp"
#include "measurement/planning/prototype_finger.hpp"

namespace coilwright::measurement::planning {
namespace {

PlannedRun motion(std::string name, InputShape input) {
  PlannedRun run{.plan = {.name = std::move(name), .kind = data::RunKind::transient, .drive = data::Drive::current},
                 .input = std::move(input),
                 .duration = 2.0,
                 .rate = 60.0};
  run.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
  return run;
}

// A laboratory with all that an experiment can say of one.
Experiment laboratory() {
  Experiment out{.name = "laboratory",
                 .instruments = {},
                 .runs = {motion("step.csv", StepShape{.after = 1.3, .at = 0.21}),
                          motion("hold.csv", HoldShape{.level = 0.9, .from = 0.3, .until = 1.1}),
                          motion("sine.csv", SineShape{.amplitude = 0.5, .offset = 0.6, .frequency = 1.5})}};
  out.runs[0].plan.rig = {.base_turn = 0.5, .tip_mass = 3e-3};
  out.runs[1].plan.clock = {.offset_sigma = 0.004, .rate_sigma = 1e-3, .exposure = 0.006};
  out.runs[1].input_rate = 200.0;
  out.runs[2].plan.hold = data::InputHold::unknown_within_sample;
  PlannedRun still{
      .plan = {.name = "still.csv", .kind = data::RunKind::still}, .input = {}, .duration = 60.0, .rate = 60.0};
  still.plan.channels = out.runs[0].plan.channels;
  out.runs.push_back(still);
  out.instruments.angle = {.noise = 0.3 * degree,
                           .colour = {.kind = NoiseColour::Kind::low_pass, .frequency = 6.0},
                           .outlier_share = 0.01,
                           .smallest_outlier = 5.0 * degree,
                           .largest_outlier = 10.0 * degree};
  return out;
}

TEST(RecordedExperiment, IsTheOneThatMadeTheRecords) {
  const Experiment made = laboratory();
  const LinearisedRecords records(made, finger().model, 3);
  const Experiment found = recorded_experiment(records.runs(), records.base().fit);
  ASSERT_EQ(found.runs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const PlannedRun& truth = made.runs[i];
    EXPECT_EQ(found.runs[i].plan.name, truth.plan.name);
    EXPECT_DOUBLE_EQ(found.runs[i].rate, 60.0);
    EXPECT_DOUBLE_EQ(found.runs[i].duration, 2.0);
    EXPECT_DOUBLE_EQ(found.runs[i].input_rate, truth.input_rate);
    EXPECT_EQ(found.runs[i].plan.clock.exposure, truth.plan.clock.exposure);
    EXPECT_EQ(found.runs[i].plan.clock.offset_sigma, truth.plan.clock.offset_sigma);
    EXPECT_EQ(found.runs[i].plan.clock.rate_sigma, truth.plan.clock.rate_sigma);
    EXPECT_EQ(found.runs[i].plan.hold, truth.plan.hold);
    EXPECT_EQ(found.runs[i].plan.rig, truth.plan.rig);
    EXPECT_TRUE(can_be_repeated(found.runs[i]));
  }
  // An edge is known to a sample of the log.
  const auto step = std::get<StepShape>(found.runs[0].input);
  EXPECT_EQ(step.before, 0.0);
  EXPECT_EQ(step.after, 1.3);
  EXPECT_NEAR(step.at, 0.21, 1.0 / 60.0);
  const auto hold = std::get<HoldShape>(found.runs[1].input);
  EXPECT_EQ(hold.level, 0.9);
  EXPECT_NEAR(hold.from, 0.3, 1.0 / 200.0);
  EXPECT_NEAR(hold.until, 1.1, 1.0 / 200.0);
  EXPECT_GT(std::get<TableShape>(found.runs[2].input).rows.size(), 100u);
  // 60 s of noise through a low pass of 6 Hz: about 1100 independent samples, 2 % in the deviation and 10 % in the
  // corner, which the band of a quarter octave blurs further.
  EXPECT_NEAR(found.instruments.angle.noise, 0.3 * degree, 0.1 * 0.3 * degree);
  EXPECT_EQ(found.instruments.angle.colour.kind, NoiseColour::Kind::low_pass);
  EXPECT_NEAR(found.instruments.angle.colour.frequency, 6.0, 2.0);
  EXPECT_GT(found.instruments.angle.outlier_share, 0.0);
  EXPECT_LT(found.instruments.angle.outlier_share, 0.03);
  EXPECT_GT(found.instruments.angle.smallest_outlier, 3.0 * degree);
  EXPECT_LT(found.instruments.angle.largest_outlier, 12.0 * degree);
}

// A second route: what is recorded again, without noise, is the same motion.
TEST(RecordedExperiment, MovesTheFingerAsTheFirstOneDid) {
  Experiment first = laboratory();
  first.runs.pop_back();
  for (PlannedRun& run : first.runs) {
    run.plan.clock = {};
    run.plan.hold = {};
    run.input_rate = 0.0;
  }
  first.instruments = {};
  first.instruments.angle.noise = 1e-5 * degree;
  const LinearisedRecords records(first, finger().model, 1);
  Experiment again = recorded_experiment(records.runs(), records.base().fit);
  first.instruments = again.instruments = {};
  const auto before = simulate_experiment(first, finger().model, {}, 1);
  const auto after = simulate_experiment(again, finger().model, {}, 1);
  for (std::size_t r = 0; r < before.size(); ++r) {
    ASSERT_EQ(after[r].samples(), before[r].samples());
    EXPECT_EQ(after[r].inputs, before[r].inputs);
    // The same samples of the same input; times differ in their last digits.
    for (std::size_t i = 0; i < before[r].samples(); ++i)
      EXPECT_NEAR(after[r].channels[0].values[i], before[r].channels[0].values[i], 1e-6 * degree) << r << " " << i;
  }
}

TEST(RecordedExperiment, CannotRepeatWhatBeganAnywhereOrHasALongLog) {
  PlannedRun run = motion("a.csv", StepShape{});
  EXPECT_TRUE(can_be_repeated(run));
  run.plan.start = data::Start::free;
  EXPECT_FALSE(can_be_repeated(run));
  TableShape log;
  for (int i = 0; i < 6000; ++i) {
    log.times.push_back(0.001 * i);
    log.rows.push_back({0.001 * i});
  }
  EXPECT_FALSE(can_be_repeated(motion("b.csv", log)));
}

TEST(CandidateRuns, StayWithinTheLevelsAndChangeTheRigToo) {
  Experiment plain = laboratory();
  plain.runs = {motion("step.csv", StepShape{.after = 0.8, .at = 0.2})};
  const LinearisedRecords records(Experiment{.name = "x", .instruments = laboratory().instruments, .runs = plain.runs},
                                  finger().model, 1);
  const actuator::Model nominal = records.base().hypothesis.model_at(records.base().fit.values);
  const std::vector<CandidateRun> menu = candidate_runs(plain, nominal, "next_");
  bool turned = false;
  bool weight = false;
  bool open = false;
  bool shorted = false;
  for (const CandidateRun& each : menu) {
    EXPECT_EQ(each.run.plan.name, "next_" + each.kind + ".csv");
    turned = turned || each.run.plan.rig.base_turn != 0.0;
    weight = weight || each.run.plan.rig.tip_mass > 0.0;
    open = open || each.run.plan.rig.coil == data::CoilWiring::open;
    shorted = shorted || each.run.plan.rig.coil == data::CoilWiring::shorted;
    const Experiment one{.name = each.kind, .instruments = {}, .runs = {each.run}};
    const std::vector<data::Run> seen = simulate_experiment(one, finger().model, {}, 1);
    for (const auto& row : seen.front().inputs)
      for (const double level : row) EXPECT_LE(std::abs(level), 0.8 + 1e-12) << each.kind;
  }
  EXPECT_TRUE(turned && weight && open && shorted);
  // Where two clocks differ nobody knows when a hand let go.
  plain.runs[0].plan.clock.offset_sigma = 0.01;
  for (const CandidateRun& each : candidate_runs(plain, nominal, ""))
    EXPECT_EQ(each.run.plan.rig.coil, data::CoilWiring::driven) << each.kind;
  plain.runs[0].input = StepShape{};
  EXPECT_TRUE(candidate_runs(plain, nominal, "").empty());
}

}  // namespace
}  // namespace coilwright::measurement::planning
