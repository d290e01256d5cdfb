#include "coilwright/formats/data/experiment_file.hpp"

#include <gtest/gtest.h>

#include "degree.hpp"
#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using namespace measurement::data;
using namespace measurement::planning;

std::string with_runs(const std::string& runs) {
  return R"({"format": "experiment/1", "name": "x", "sampling_rate_Hz": 500, "runs": [)" + runs + "]}";
}

PlannedRun planned_run(const std::string& run) {
  return parse_experiment(with_runs(run), "x.json").runs.at(0);
}

PlannedRun driven_by(const std::string& input) {
  return planned_run(R"({"file": "a.csv", "role": "fit", "duration_s": 2, "input": )" + input + "}");
}

std::string experiment_refusal(const std::string& run) {
  return text::testing::error_of([&] { (void)parse_experiment(with_runs(run), "x.json"); });
}

TEST(ExperimentFile, TheShippedOneIsLikeThePapers) {
  const Experiment experiment =
      read_experiment(std::filesystem::path(COILWRIGHT_SOURCE_DIR) / "configs" / "experiments" / "paper.json");
  EXPECT_NEAR(experiment.instruments.angle.noise, 0.3 * degree, 1e-15);
  EXPECT_NEAR(experiment.instruments.angle.resolution, 0.02 * degree, 1e-15);
  EXPECT_EQ(experiment.instruments.torque.noise, 0.0);
  std::size_t fit = 0;
  for (const PlannedRun& each : experiment.runs) {
    fit += each.validate ? 0 : 1;
    ASSERT_EQ(each.plan.channels.size(), 1u);
    EXPECT_EQ(each.plan.channels[0].kind, ChannelKind::bending_angle);
  }
  EXPECT_EQ(fit, 10u);
  EXPECT_EQ(experiment.runs.size(), 14u);
  EXPECT_EQ(experiment.runs[0].rate, 500.0);
  EXPECT_EQ(experiment.runs[9].rate, 250.0);
}

TEST(ExperimentFile, SaysHowALaboratoryRecords) {
  const Experiment experiment = parse_experiment(R"({
    "format": "experiment/1", "name": "x", "sampling_rate_Hz": 60, "exposure_s": 0.008, "clock_offset_s": 0.01,
    "clock_rate": 0.002, "input_hold": "linear", "input_rate_Hz": 100,
    "noise": {"angle_deg": 0.3}, "noise_colour": {"angle_deg": {"kind": "low_pass", "frequency_Hz": 10}},
    "hum": {"frequency_Hz": 50, "angle_deg": 0.2}, "outliers": {"share": 0.02, "angle_deg": [3, 10]},
    "input_noise": {"current_A": 0.02},
    "runs": [{"file": "still.csv", "kind": "still", "duration_s": 5},
             {"file": "a.csv", "role": "fit", "duration_s": 2, "input": {"step": {"after_A": 1, "at_s": 0.1}},
              "exposure_s": 0, "input_hold": "zero_order", "input_sigma": 0.05, "input_correlation_s": 0.2,
              "rig": {"base_turn_deg": 90, "tip_mass_g": 5, "coil": "open"}},
             {"file": "b.csv", "role": "fit", "duration_s": 2, "input": {"step": {"after_A": 1, "at_s": 0.1}}}]})",
                                                 "x.json");
  const Instrument& camera = experiment.instruments.angle;
  EXPECT_EQ(camera.colour.kind, NoiseColour::Kind::low_pass);
  EXPECT_EQ(camera.colour.frequency, 10.0);
  EXPECT_DOUBLE_EQ(camera.hum, 0.2 * degree);
  EXPECT_EQ(camera.hum_frequency, 50.0);
  EXPECT_EQ(camera.outlier_share, 0.02);
  EXPECT_DOUBLE_EQ(camera.smallest_outlier, 3.0 * degree);
  EXPECT_DOUBLE_EQ(camera.largest_outlier, 10.0 * degree);
  EXPECT_EQ(experiment.instruments.torque.outlier_share, 0.0);
  EXPECT_EQ(experiment.instruments.input_noise, 0.02);
  const PlannedRun& still = experiment.runs[0];
  EXPECT_EQ(still.plan.kind, RunKind::still);
  EXPECT_FALSE(still.validate);
  EXPECT_EQ(still.duration, 5.0);
  EXPECT_EQ(still.rate, 60.0);
  const PlannedRun& own = experiment.runs[1];
  EXPECT_EQ(own.plan.clock.exposure, 0.0);
  EXPECT_EQ(own.plan.clock.offset_sigma, 0.01);
  EXPECT_EQ(own.plan.hold, InputHold::zero_order);
  EXPECT_EQ(own.plan.input_uncertainty, (InputUncertainty{.sigma = {0.05}, .correlation = 0.2}));
  EXPECT_DOUBLE_EQ(own.plan.rig.base_turn, 90.0 * degree);
  EXPECT_EQ(own.plan.rig.tip_mass, 5e-3);
  EXPECT_EQ(own.plan.rig.coil, CoilWiring::open);
  const PlannedRun& usual = experiment.runs[2];
  EXPECT_EQ(usual.plan.clock.exposure, 0.008);
  EXPECT_EQ(usual.plan.clock.rate_sigma, 0.002);
  EXPECT_EQ(usual.plan.hold, InputHold::linear);
  EXPECT_EQ(usual.input_rate, 100.0);
}

TEST(ExperimentFile, RefusesWhatNoLaboratoryHas) {
  const auto with = [](const std::string& keys) {
    return text::testing::error_of([&] {
      (void)parse_experiment(R"({"format": "experiment/1", "name": "x", "sampling_rate_Hz": 60, )" + keys +
                                 R"(, "runs": [{"file": "s.csv", "kind": "still", "duration_s": 5}]})",
                             "x.json");
    });
  };
  EXPECT_EQ(
      with(R"("noise_colour": {"angle_deg": {"kind": "pink"}})"),
      R"(x.json: /noise_colour/angle_deg/kind: must be one of "white", "low_pass", "one_over_f"; got text "pink")");
  EXPECT_EQ(with(R"("noise_colour": {"angle_deg": {"kind": "low_pass"}})"),
            "x.json: /noise_colour/angle_deg/frequency_Hz: is missing");
  EXPECT_EQ(with(R"("outliers": {"share": 2})"), "x.json: /outliers/share: must be from 0 to 1; got 2");
  EXPECT_EQ(with(R"("outliers": {"share": 0.1, "angle_deg": [10, 3]})"),
            "x.json: /outliers/angle_deg: must give the smallest size first; got an array of 2");
  EXPECT_EQ(with(R"("clock_rate": 0.5)"), "x.json: /clock_rate: must be from 0 to 0.2; got 0.5");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "kind": "still", "role": "validate", "duration_s": 5})"),
            "x.json: /runs/0/role: must be \"fit\": every run uses a still run, and none is held out; got text "
            "\"validate\"");
  EXPECT_EQ(experiment_refusal(
                R"({"file": "a.csv", "role": "fit", "duration_s": 2, "start": "free", "start_angles_deg": [9, 9],
                        "exposure_s": 0.01, "input": {"step": {"after_A": 1, "at_s": 0.1}}})"),
            "x.json: /runs/0/start_angles_deg: must not be there beside input_rate_Hz, clock_offset_s or exposure_s: "
            "the time of the release is that of the first sample");
}

TEST(ExperimentFile, HasAShapeForEachOfTheMenu) {
  const auto step = std::get<StepShape>(driven_by(R"({"step": {"before_A": 0.1, "after_A": 1.4, "at_s": 0.2}})").input);
  EXPECT_EQ(step.before, 0.1);
  EXPECT_EQ(step.after, 1.4);
  EXPECT_EQ(step.at, 0.2);
  const auto sine =
      std::get<SineShape>(driven_by(R"({"sine": {"amplitude_A": 0.7, "offset_A": 0.6, "frequency_Hz": 3}})").input);
  EXPECT_EQ(sine.amplitude, 0.7);
  EXPECT_EQ(sine.offset, 0.6);
  EXPECT_EQ(sine.frequency, 3.0);
  const auto chirp =
      std::get<ChirpShape>(driven_by(R"({"chirp": {"amplitude_A": 0.5, "from_Hz": 0.5, "to_Hz": 20}})").input);
  EXPECT_EQ(chirp.offset, 0.0);
  EXPECT_EQ(chirp.from, 0.5);
  EXPECT_EQ(chirp.to, 20.0);
  const auto release = std::get<StepShape>(driven_by(R"({"release": {"level_A": 1.4, "at_s": 0.2}})").input);
  EXPECT_EQ(release.before, 1.4);
  EXPECT_EQ(release.after, 0.0);
  const auto hold =
      std::get<HoldShape>(driven_by(R"({"hold": {"level_A": 1.05, "from_s": 0.1, "until_s": 1.5}})").input);
  EXPECT_EQ(hold.level, 1.05);
  EXPECT_EQ(hold.until, 1.5);
  const auto pulses =
      std::get<PulseShape>(driven_by(R"({"pulses": {"high_A": 1.2, "period_s": 0.8, "duty": 0.25}})").input);
  EXPECT_EQ(pulses.low, 0.0);
  EXPECT_EQ(pulses.high, 1.2);
  EXPECT_EQ(pulses.duty, 0.25);
}

TEST(ExperimentFile, TakesAnInputFromAFileBesideIt) {
  const ::coilwright::testing::TemporaryFolder folder;
  (void)folder.file("in.csv", "time_s,current1_A,current2_A\n1,0.5,0\n1.5,0.5,1\n3,0,0\n");
  const auto path = folder.file(
      "x.json",
      with_runs(R"({"file": "a.csv", "role": "validate", "input": {"file": "in.csv"}, "sampling_rate_Hz": 10})"));
  const PlannedRun run = read_experiment(path).runs.at(0);
  EXPECT_TRUE(run.validate);
  EXPECT_EQ(run.duration, 2.0);
  EXPECT_EQ(run.rate, 10.0);
  const auto& table = std::get<TableShape>(run.input);
  EXPECT_EQ(table.rows[1], (std::vector<double>{0.5, 1.0}));
}

TEST(ExperimentFile, DrivesByVoltageAndTorqueInTheirUnits) {
  const PlannedRun torque =
      planned_run(R"({"file": "a.csv", "role": "fit", "duration_s": 2, "drive": "torque", "joint": 2,
      "start": "free", "start_angles_deg": [30, 0], "measure": ["theta1_deg", "theta2_rad", "omega1_rad_s"],
      "input": {"step": {"after_Nmm": 3, "at_s": 0.2}}})");
  EXPECT_EQ(torque.plan.drive, Drive::torque);
  EXPECT_EQ(torque.only, 1);
  EXPECT_EQ(torque.plan.start, Start::free);
  EXPECT_NEAR(torque.start_angles[0], 30 * degree, 1e-15);
  EXPECT_EQ(std::get<StepShape>(torque.input).after, 0.003);
  ASSERT_EQ(torque.plan.channels.size(), 3u);
  EXPECT_EQ(torque.plan.channels[1].name, "theta2_rad");
  EXPECT_EQ(torque.plan.channels[1].kind, ChannelKind::joint_angle);
  EXPECT_EQ(torque.plan.channels[1].joint, 1);
  EXPECT_EQ(torque.plan.channels[2].kind, ChannelKind::joint_rate);
  const PlannedRun voltage = planned_run(R"({"file": "a.csv", "role": "fit", "duration_s": 2, "drive": "voltage",
      "input": {"step": {"after_V": 4, "at_s": 0.2}}})");
  EXPECT_EQ(std::get<StepShape>(voltage.input).after, 4.0);
}

TEST(ExperimentFile, PlansBenches) {
  const auto torque = planned_run(R"({"file": "a.csv", "role": "fit", "kind": "static_torque", "angles_deg": [0, 45],
      "currents_A": [0.7, 1.4]})")
                          .plan;
  EXPECT_EQ(torque.kind, RunKind::static_torque);
  EXPECT_EQ(torque.angles.size(), 4u);
  EXPECT_NEAR(torque.angles[3], 45 * degree, 1e-15);
  EXPECT_EQ(torque.inputs[2], std::vector<double>{1.4});
  EXPECT_EQ(torque.channels[0].name, "torque_Nmm");
  const auto stiffness =
      planned_run(R"({"file": "a.csv", "role": "fit", "kind": "joint_stiffness", "angles_deg": [10, 20, 30]})").plan;
  EXPECT_EQ(stiffness.angles.size(), 3u);
  EXPECT_TRUE(stiffness.inputs.empty());
  const auto force =
      planned_run(R"({"file": "a.csv", "role": "fit", "kind": "blocked_force", "currents_A": [1]})").plan;
  EXPECT_EQ(force.channels[0].kind, ChannelKind::force);
  const PlannedRun heat = planned_run(R"({"file": "a.csv", "role": "fit", "kind": "temperature", "duration_s": 60,
      "sampling_rate_Hz": 1, "input": {"hold": {"level_A": 1, "from_s": 0, "until_s": 30}}})");
  EXPECT_EQ(heat.plan.channels[0].name, "temperature_degC");
}

TEST(ExperimentFile, IsRefusedInALineThatNamesPlaceRuleAndValue) {
  const std::string head = R"("role": "fit", "duration_s": 2, )";
  const std::string step = R"("input": {"step": {"after_A": 1, "at_s": 0.1}})";
  EXPECT_EQ(experiment_refusal(""), "x.json: /runs: must have 1 to 1000 elements; got an array of 0");
  EXPECT_EQ(experiment_refusal(R"({"file": "../a.csv", )" + head + step + "}"),
            R"(x.json: /runs/0/file: must be a plain file name that ends in .csv; got text "../a.csv")");
  EXPECT_EQ(experiment_refusal(R"({"file": "dataset.json", )" + head + step + "}"),
            R"(x.json: /runs/0/file: must be a plain file name that ends in .csv; got text "dataset.json")");
  const std::string good = R"({"file": "a.csv", )" + head + step + "}";
  EXPECT_EQ(experiment_refusal(good + "," + good),
            R"(x.json: /runs/1/file: must not be there twice; got text "a.csv")");
  EXPECT_EQ(
      experiment_refusal(good + "," + R"({"file": "A.csv", )" + head + step + "}"),
      R"(x.json: /runs/1/file: must differ from "a.csv" by more than capitals: on many systems they are one file; )"
      R"(got text "A.csv")");
  // A name is that of a file, and stands in tables.
  EXPECT_EQ(experiment_refusal(R"({"file": "a\u0000.csv", )" + head + step + "}"),
            R"(x.json: /runs/0/file: must be one line without control characters; got text "a\x00.csv")");
  EXPECT_EQ(
      experiment_refusal(R"({"file": "a_input.csv", )" + head + step + "}," +
                         R"({"file": "a.csv", "input_rate_Hz": 100, )" + head + step + "}"),
      "x.json: /runs/1/file: must be another name: its input is written to a_input.csv, which is there already; got "
      "text \"a.csv\"");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "role": "train", "duration_s": 2, )" + step + "}"),
            R"(x.json: /runs/0/role: must be one of "fit", "validate"; got text "train")");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", )" + head + R"("input": {"step": {"after_V": 1, "at_s": 0.1}}})"),
            R"(x.json: /runs/0/input/step/after_V: unknown key; did you mean "after_A"?)");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", )" + head +
                               R"("input": {"hold": {"level_A": 1, "from_s": 0.5, "until_s": 0.5}}})"),
            "x.json: /runs/0/input/hold/until_s: must exceed from_s (0.5); got 0.5");
  EXPECT_EQ(text::testing::error_of([] {
              (void)parse_experiment(R"({"format": "experiment/1", "name": "x", "sampling_rate_hz": 60, "runs": [
                  {"file": "a.csv", "role": "fit", "duration_s": 2, "input": {"step": {"after_A": 1, "at_s": 0}}}]})",
                                     "x.json");
            }),
            R"(x.json: /sampling_rate_hz: unknown key; did you mean "sampling_rate_Hz"?)");
  // Nothing of such a change would be recorded.
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", )" + head + R"("input": {"step": {"after_A": 1, "at_s": 2}}})"),
            "x.json: /runs/0/input/step/at_s: must be below the run's duration, 2 s; got 2");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", )" + head + R"("input": {"release": {"level_A": 1, "at_s": 3}}})"),
            "x.json: /runs/0/input/release/at_s: must be below the run's duration, 2 s; got 3");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", )" + head +
                               R"("input": {"hold": {"level_A": 1, "from_s": 2.5, "until_s": 3}}})"),
            "x.json: /runs/0/input/hold/from_s: must be below the run's duration, 2 s; got 2.5");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "role": "fit", "duration_s": 0.002, )" + step + "}"),
            "x.json: /runs/0: duration_s times sampling_rate_Hz must be from 5 to 1000000; got 1");
  // At 500 Hz, the next picture begins after 2 ms.
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "exposure_s": 0.003, )" + head + step + "}"),
            "x.json: /runs/0: exposure_s must be at most the time between two samples, 0.002 s; got 0.003");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "start_angles_deg": [1, 1], )" + head + step + "}"),
            R"(x.json: /runs/0/start_angles_deg: must not be there where the start is "at_rest"; got an array of 2)");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "drive": "voltage", "coil": 1, )" + head +
                               R"("input": {"step": {"after_V": 1, "at_s": 0.1}}})"),
            "x.json: /runs/0/coil: must not be there under a voltage, which all coils share; got 1");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "measure": ["speed"], )" + head + step + "}"),
            "x.json: /runs/0/measure/0: must be measured columns: bending_angle_deg, theta1_deg, .. or omega1_rad_s, "
            R"(..; got text "speed")");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "measure": ["theta2_deg"], )" + head + step + "}"),
            R"(x.json: /runs/0/measure/0: must be numbered 1, 2, .. in turn; got text "theta2_deg")");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "measure": ["theta1_deg", "theta1_rad"], )" + head + step + "}"),
            R"(x.json: /runs/0/measure/1: must be numbered 1, 2, .. in turn; got text "theta1_rad")");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", "measure": ["bending_angle_deg", "bending_angle_rad"], )" + head +
                               step + "}"),
            R"(x.json: /runs/0/measure/1: must not be there twice; got text "bending_angle_rad")");
  EXPECT_EQ(experiment_refusal(R"({"file": "a.csv", )" + head +
                               R"("input": {"step": {"after_A": 1, "at_s": 0.1}, "sine": {}}})"),
            R"(x.json: /runs/0/input/sine: cannot stand beside "step")");
}

TEST(ExperimentFile, NoiseMayBeSetByAnArgument) {
  Instruments instruments;
  set_noise(instruments, "angle_deg=0.5");
  EXPECT_NEAR(instruments.angle.noise, 0.5 * degree, 1e-15);
  set_noise(instruments, "temperature_K=0.5");
  EXPECT_EQ(instruments.temperature.noise, 0.5);
  const auto refused = [&](const char* argument) {
    return text::testing::error_of([&] { set_noise(instruments, argument); });
  };
  EXPECT_EQ(refused("angel_deg=1"), R"(angel_deg=1: is not a noise of an instrument; did you mean "angle_deg"?)");
  EXPECT_EQ(refused("angle_deg=-1"), "angle_deg=-1: must be from 0 to 1000000");
  EXPECT_EQ(refused("0.3"), R"(0.3: must be a name and a value, as in "angle_deg=0.3")");
}

}  // namespace
}  // namespace coilwright::formats
