
#include <gtest/gtest.h>

#include <stdexcept>

#include "coilwright/formats/data/experiment_file.hpp"
#include "degree.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using namespace measurement::data;
using namespace measurement::planning;

// Every key of the format, no value a round one in memory.
constexpr const char* everything = R"({
  "format": "experiment/1", "name": "all of it", "sampling_rate_Hz": 60, "exposure_s": 0.008, "clock_offset_s": 0.01,
  "clock_rate": 0.002, "input_hold": "unknown_within_sample", "input_rate_Hz": 100,
  "measure": ["bending_angle_deg", "theta1_rad", "omega1_rad_s"],
  "noise": {"angle_deg": 0.3, "rate_deg_s": 7, "torque_Nmm": 0.05, "force_N": 0.01, "temperature_K": 0.4},
  "resolution": {"angle_deg": 0.02},
  "noise_colour": {"angle_deg": {"kind": "low_pass", "frequency_Hz": 11}, "rate_deg_s": {"kind": "one_over_f"}},
  "hum": {"frequency_Hz": 50, "angle_deg": 0.2}, "outliers": {"share": 0.02, "angle_deg": [3, 10]},
  "input_noise": {"current_A": 0.02},
  "runs": [
    {"file": "still.csv", "kind": "still", "duration_s": 7},
    {"file": "step.csv", "role": "fit", "duration_s": 2, "input": {"step": {"before_A": 0.1, "after_A": 1.3, "at_s": 0.2}}},
    {"file": "sine.csv", "role": "validate", "duration_s": 3, "coil": 2,
     "input": {"sine": {"amplitude_A": 0.7, "offset_A": 0.6, "frequency_Hz": 3}}},
    {"file": "chirp.csv", "role": "fit", "duration_s": 4, "sampling_rate_Hz": 240, "exposure_s": 0.002, "measure": ["bending_angle_deg"],
     "input": {"chirp": {"amplitude_A": 0.4, "offset_A": 0.5, "from_Hz": 0.5, "to_Hz": 12}},
     "rig": {"base_turn_deg": 33, "tip_mass_g": 5.3, "coil": "shorted"}},
    {"file": "hold.csv", "role": "fit", "duration_s": 5, "drive": "voltage",
     "input": {"hold": {"level_V": 4.1, "from_s": 0.3, "until_s": 3.1}}},
    {"file": "pulses.csv", "role": "fit", "duration_s": 5, "drive": "torque", "joint": 2,
     "input": {"pulses": {"low_Nmm": 0.3, "high_Nmm": 3.7, "period_s": 0.9, "duty": 0.3}}},
    {"file": "levels.csv", "role": "fit", "duration_s": 5,
     "input": {"levels": {"at_s": [0, 0.7, 3], "level_A": [0, 1.1, 0.3]}}},
    {"file": "each.csv", "role": "fit", "duration_s": 5,
     "input": {"levels": {"at_s": [0, 0.7], "level_A": [[0, 0.2], [1.1, 0.3]]}}},
    {"file": "held.csv", "role": "fit", "duration_s": 2, "start": "free", "start_angles_deg": [31, 17],
     "exposure_s": 0, "clock_offset_s": 0, "clock_rate": 0,
     "input_hold": "zero_order", "input": {"release": {"level_A": 0.9, "at_s": 0.4}}},
    {"file": "torque.csv", "role": "fit", "kind": "static_torque", "angles_deg": [0, 13, 44], "currents_A": [0.7, 1.4]},
    {"file": "gauge.csv", "role": "validate", "kind": "joint_stiffness", "angles_deg": [11, 23]},
    {"file": "wall.csv", "role": "fit", "kind": "blocked_force", "currents_A": [0.3, 0.9]},
    {"file": "heat.csv", "role": "fit", "kind": "temperature", "duration_s": 60, "sampling_rate_Hz": 1,
     "input": {"hold": {"level_A": 1, "from_s": 0, "until_s": 30}}}]})";

// The last run could not be held where the experiment's input has a clock of its own.
Experiment written() {
  std::string text = everything;
  const std::string clock = ", \"input_rate_Hz\": 100";
  text.erase(text.find(clock), clock.size());
  Experiment out = parse_experiment(text, "x.json");
  out.runs[1].input_rate = 100.0;
  out.runs[1].plan.input_uncertainty = {.sigma = {0.02}, .correlation = 0.1};
  return out;
}

Experiment read_back(const Experiment& experiment) {
  return parse_experiment(experiment_json(experiment, "as planned").text(), "back.json");
}

void expect_same(const Instrument& a, const Instrument& b) {
  EXPECT_EQ(a.noise, b.noise);
  EXPECT_EQ(a.resolution, b.resolution);
  EXPECT_EQ(a.colour.kind, b.colour.kind);
  EXPECT_EQ(a.colour.frequency, b.colour.frequency);
  EXPECT_EQ(a.hum, b.hum);
  EXPECT_EQ(a.outlier_share, b.outlier_share);
  EXPECT_EQ(a.smallest_outlier, b.smallest_outlier);
  EXPECT_EQ(a.largest_outlier, b.largest_outlier);
}

TEST(ExperimentWriter, WritesWhatReadsBackToTheBit) {
  const Experiment experiment = written();
  const Experiment back = read_back(experiment);
  EXPECT_EQ(back.name, "all of it");
  for (const ChannelKind kind : {ChannelKind::bending_angle, ChannelKind::joint_rate, ChannelKind::torque,
                                 ChannelKind::force, ChannelKind::temperature})
    expect_same(back.instruments.of(kind), experiment.instruments.of(kind));
  EXPECT_EQ(back.instruments.input_noise, 0.02);
  ASSERT_EQ(back.runs.size(), experiment.runs.size());
  for (std::size_t i = 0; i < back.runs.size(); ++i) {
    const PlannedRun& a = experiment.runs[i];
    const PlannedRun& b = back.runs[i];
    SCOPED_TRACE(a.plan.name);
    EXPECT_EQ(b.plan.name, a.plan.name);
    EXPECT_EQ(b.plan.kind, a.plan.kind);
    EXPECT_EQ(b.plan.drive, a.plan.drive);
    EXPECT_EQ(b.plan.start, a.plan.start);
    EXPECT_EQ(b.plan.hold, a.plan.hold);
    EXPECT_EQ(b.plan.input_uncertainty, a.plan.input_uncertainty);
    EXPECT_EQ(b.plan.rig, a.plan.rig);
    EXPECT_EQ(b.plan.clock.exposure, a.plan.clock.exposure);
    EXPECT_EQ(b.plan.clock.offset_sigma, a.plan.clock.offset_sigma);
    EXPECT_EQ(b.plan.clock.rate_sigma, a.plan.clock.rate_sigma);
    EXPECT_EQ(b.plan.angles, a.plan.angles);
    EXPECT_EQ(b.plan.inputs, a.plan.inputs);
    ASSERT_EQ(b.plan.channels.size(), a.plan.channels.size());
    for (std::size_t c = 0; c < a.plan.channels.size(); ++c)
      EXPECT_EQ(b.plan.channels[c].name, a.plan.channels[c].name);
    EXPECT_EQ(b.validate, a.validate);
    EXPECT_EQ(b.only, a.only);
    EXPECT_EQ(b.start_angles, a.start_angles);
    EXPECT_EQ(b.duration, a.duration);
    EXPECT_EQ(b.rate, a.rate);
    EXPECT_EQ(b.input_rate, a.input_rate);
    EXPECT_EQ(b.input.index(), a.input.index());
  }
  // Shapes, which have no comparison, by what they write.
  EXPECT_EQ(experiment_json(back).text(), experiment_json(experiment).text());
  EXPECT_EQ(std::get<PulseShape>(back.runs[5].input).high, std::get<PulseShape>(experiment.runs[5].input).high);
  const auto& rows = std::get<TableShape>(back.runs[7].input).rows;
  EXPECT_EQ(rows, (std::vector<std::vector<double>>{{0.0, 0.2}, {1.1, 0.3}}));
}

TEST(ExperimentWriter, LeavesOutWhatTheRigDoesNotHave) {
  Experiment plain{.name = "plain", .instruments = {}, .runs = {written().runs[6]}};
  plain.instruments.angle.noise = 0.3 * degree;
  const std::string text = experiment_json(plain).text();
  EXPECT_EQ(text.find("hum"), std::string::npos);
  EXPECT_EQ(text.find("outliers"), std::string::npos);
  EXPECT_EQ(text.find("description"), std::string::npos);
  EXPECT_EQ(text.find("torque"), std::string::npos);
}

TEST(ExperimentWriter, RefusesABenchThatTheFormatHasNoKeysFor) {
  Experiment grasp{.name = "grasp", .instruments = {}, .runs = {written().runs[11]}};
  grasp.runs[0].plan.openings = {0.1, 0.2};
  EXPECT_THROW((void)experiment_json(grasp), std::invalid_argument);
  Experiment torque{.name = "torque", .instruments = {}, .runs = {written().runs[9]}};
  torque.runs[0].plan.angles[4] += 0.1;
  EXPECT_THROW((void)experiment_json(torque), std::invalid_argument);
}

std::string levels_refused(const std::string& levels) {
  return text::testing::error_of([&] {
    (void)parse_experiment(R"({"format": "experiment/1", "name": "x", "sampling_rate_Hz": 60, "runs": [{"file": "a.csv",
                              "role": "fit", "duration_s": 2, "input": {"levels": )" +
                               levels + "}}]}",
                           "x.json");
  });
}

TEST(ExperimentFile, RefusesLevelsThatNoDriverCouldFollow) {
  EXPECT_EQ(levels_refused(R"({"at_s": [0.1, 1], "level_A": [0, 1]})"),
            "x.json: /runs/0/input/levels/at_s: must begin at 0");
  EXPECT_EQ(levels_refused(R"({"at_s": [0, 1, 1], "level_A": [0, 1, 2]})"),
            "x.json: /runs/0/input/levels/at_s: must increase");
  EXPECT_EQ(levels_refused(R"({"at_s": [0, 1], "level_A": [0, [1, 2]]})"),
            "x.json: /runs/0/input/levels/level_A/1: must have as many levels as the first one; got an array of 2");
  EXPECT_EQ(levels_refused(R"({"at_s": [0, 1], "level_A": [0]})"),
            "x.json: /runs/0/input/levels/level_A: must have 2 elements; got an array of 1");
}

}  // namespace
}  // namespace coilwright::formats
