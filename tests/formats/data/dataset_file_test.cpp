#include "coilwright/formats/data/dataset_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"

#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using measurement::data::RunKind;
using measurement::data::Start;
using measurement::replay::Tolerances;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string step = "time_s,current_A,bending_angle_deg\n0,0,1\n0.01,1.4,2\n0.02,1.4,4.5\n0.03,1.4,6.5\n";
const std::string bench = "angle_deg,current_A,torque_Nmm\n10,1.4,17\n20,1.4,16\n";

// A folder with two motions and a bench, and whatever dataset.json a test gives it.
class DatasetFiles : public ::testing::Test {
 protected:
  DatasetFiles() {
    folder_.file("a.csv", step);
    folder_.file("b.csv", step);
    folder_.file("bench.csv", bench);
  }
  void write(std::string_view name, std::string_view content) { folder_.file(name, content); }
  DatasetFile read(const std::string& json) { return read_dataset(folder_.file("dataset.json", json)); }
  DatasetFile read_runs(const std::string& runs) {
    return read(R"({"format": "measured-data/1", "runs": [)" + runs + "]}");
  }
  // Without the folder's name.
  std::string refusal(const std::string& json) {
    std::string text = text::testing::error_of([&] { (void)read(json); });
    const std::string prefix = folder_.path().string() + "/";
    return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
  }
  std::string runs_refusal(const std::string& runs) {
    return refusal(R"({"format": "measured-data/1", "runs": [)" + runs + "]}");
  }

  coilwright::testing::TemporaryFolder folder_;
};

const std::string run_a = R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "current"})";
const std::string run_b = R"({"file": "b.csv", "kind": "transient", "role": "validate", "drive": "current"})";

TEST_F(DatasetFiles, AreReadToTheLetter) {
  const DatasetFile file = read(R"({
    "format": "measured-data/1", "name": "finger", "actuator": "../configs/finger.json",
    "calibrate": ["/links/0/mass_kg", "joint_damping"],
    "runs": [
      {"file": "a.csv", "kind": "transient", "role": "fit", "drive": "current", "start": "free", "window_s": 0.5,
       "sigma": 0.3},
      {"file": "b.csv", "kind": "transient", "role": "validate", "drive": "current", "start": "at_rest"},
      {"file": "bench.csv", "kind": "static_torque", "role": "fit"}
    ]})");
  EXPECT_EQ(file.data.name, "finger");
  EXPECT_EQ(*file.actuator, folder_.path() / "../configs/finger.json");
  EXPECT_THAT(file.calibrate, ElementsAre("/links/0/mass_kg", "joint_damping"));
  EXPECT_EQ(file.data.validate.count(), 1u);
  EXPECT_THAT(file.data.held_out, IsEmpty());
  ASSERT_EQ(file.data.fit.size(), 2u);
  const measurement::data::Run& run = file.data.fit[0];
  EXPECT_EQ(run.name, "a.csv");
  EXPECT_EQ(run.start, Start::free);
  EXPECT_EQ(run.window, 0.5);
  EXPECT_DOUBLE_EQ(*run.sigma, 0.3 * 3.14159265358979323846 / 180.0);
  EXPECT_EQ(run.samples(), 4u);
  EXPECT_EQ(file.data.fit[1].kind, RunKind::static_torque);
}

TEST_F(DatasetFiles, MayBeGivenByTheirFolder) {
  (void)read_runs(run_a + "," + run_b);
  EXPECT_EQ(read_dataset(folder_.path()).data.fit.size(), 1u);
}

TEST_F(DatasetFiles, SayWhatIsBelievedOfEffects) {
  const auto with = [&](const std::string& beliefs) {
    return R"({"format": "measured-data/1", "effect_probabilities": )" + beliefs + R"(, "runs": [)" + run_a + "]}";
  };
  const DatasetFile file = read(with(R"({"dry_friction": 0.5})"));
  ASSERT_EQ(file.beliefs.size(), 1u);
  EXPECT_EQ(file.beliefs.front().effect, "dry_friction");
  EXPECT_EQ(file.beliefs.front().probability, 0.5);
  EXPECT_EQ(refusal(with(R"({"dry_friction": 1})")),
            "dataset.json: /effect_probabilities/dry_friction: must be > 0 and < 1; got 1");
  EXPECT_EQ(refusal(with(R"({"dry_fricton": 0.5})")),
            "dataset.json: /effect_probabilities/dry_fricton: must be called by the id of an effect (coilwright list "
            "effects); did you mean \"dry_friction\"?");
}

TEST_F(DatasetFiles, HaveDefaults) {
  const DatasetFile file = read_runs(run_a + "," + run_b);
  EXPECT_THAT(file.calibrate, ElementsAre("joint_stiffness", "joint_damping"));
  EXPECT_FALSE(file.actuator);
  EXPECT_EQ(file.data.fit[0].start, Start::at_rest);
  EXPECT_FALSE(file.data.fit[0].window);
  EXPECT_FALSE(file.data.fit[0].sigma);
}

TEST_F(DatasetFiles, HoldRunsOutThemselvesWhereNoneIsNamed) {
  const DatasetFile file = read_runs(run_a + R"(, {"file": "b.csv", "kind": "transient", "role": "fit",
                                                    "drive": "current"})");
  EXPECT_THAT(file.data.held_out, ElementsAre("b.csv"));
  EXPECT_EQ(file.data.validate.count(), 1u);
  EXPECT_EQ(file.data.fit.size(), 1u);
}

TEST_F(DatasetFiles, RefuseASetWithoutAFitRun) {
  EXPECT_EQ(runs_refusal(run_b), "dataset.json: /runs: needs at least one fit run");
  EXPECT_EQ(runs_refusal(""), "dataset.json: /runs: must have 1 to 10000 elements; got an array of 0");
}

TEST_F(DatasetFiles, RefuseWordsThatDoNotExist) {
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "train", "drive": "current"})"),
            R"(dataset.json: /runs/0/role: must be one of "fit", "validate"; got text "train")");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "motion", "role": "fit", "drive": "current"})"),
            R"(dataset.json: /runs/0/kind: must be one of "transient", "static_torque", "joint_stiffness", )"
            R"("blocked_force", "temperature", "still"; got text "motion")");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "force"})"),
            R"(dataset.json: /runs/0/drive: must be one of "current", "voltage", "torque"; got text "force")");
  EXPECT_EQ(
      runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "current", "start": "moving"})"),
      R"(dataset.json: /runs/0/start: must be one of "at_rest", "measured", "free"; got text "moving")");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "current", "windw_s": 1})"),
            R"(dataset.json: /runs/0/windw_s: unknown key; did you mean "window_s"?)");
  EXPECT_EQ(refusal(R"({"format": "measured-data/2", "runs": []})"),
            R"(dataset.json: /format: must be "measured-data/1"; got text "measured-data/2")");
  EXPECT_EQ(refusal(R"({"format": "measured-data/1", "calibrate": ["stiffness"], "runs": []})"),
            R"(dataset.json: /calibrate/0: must be "joint_stiffness", "joint_damping" or a JSON pointer into the )"
            R"(actuator file; got text "stiffness")");
}

TEST_F(DatasetFiles, FindTheOneThatIsTwiceAmongAHundredThousandNames) {
  std::string names;
  for (int i = 0; i < 100'000; ++i) names += fmt::format(R"("/x/{}", )", i);
  for (const char* key : {"calibrate", "ignore"})
    EXPECT_EQ(refusal(fmt::format(R"({{"format": "measured-data/1", "{}": [{}"/x/7"], "runs": []}})", key, names)),
              fmt::format(R"(dataset.json: /{}/100000: must not be there twice; got text "/x/7")", key));
}

TEST_F(DatasetFiles, RefuseMissingKeys) {
  EXPECT_EQ(runs_refusal(R"({"kind": "transient", "role": "fit", "drive": "current"})"),
            "dataset.json: /runs/0/file: is missing");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit"})"),
            "dataset.json: /runs/0/drive: is missing");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "transient", "drive": "current"})"),
            "dataset.json: /runs/0/role: is missing");
}

TEST_F(DatasetFiles, RefuseNumbersBeyondTheirRules) {
  const auto with = [&](const std::string& key) {
    return runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "current", )" + key + "}");
  };
  EXPECT_EQ(with(R"("window_s": 0)"), "dataset.json: /runs/0/window_s: must be > 0; got 0");
  EXPECT_EQ(with(R"("window_s": 0.01)"),
            "dataset.json: /runs/0/window_s: must exceed the mean interval between samples; got 0.01");
  EXPECT_EQ(with(R"("sigma": -0.3)"), "dataset.json: /runs/0/sigma: must be from 1e-12 to 1000000000000; got -0.3");
}

TEST_F(DatasetFiles, RefuseADriveThatTheColumnsContradict) {
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "voltage"})"),
            "dataset.json: /runs/0/drive: must be \"current\", as the input column of the file says; got text "
            "\"voltage\"");
  EXPECT_EQ(runs_refusal(R"({"file": "bench.csv", "kind": "static_torque", "role": "fit", "drive": "torque"})"),
            "dataset.json: /runs/0/drive: must be \"current\", as the input column of the file says; got text "
            "\"torque\"");
}

TEST_F(DatasetFiles, RefuseAMeasuredStartWithoutAnAngle) {
  write("rates.csv", "time_s,current_A,omega1_rad_s\n0,0,1\n0.01,1.4,2\n");
  EXPECT_EQ(runs_refusal(R"({"file": "rates.csv", "kind": "transient", "role": "fit", "drive": "current",
                             "start": "measured"})"),
            "dataset.json: /runs/0/start: must not be \"measured\" where no angle is measured; got text \"measured\"");
}

TEST_F(DatasetFiles, RefuseAFileThatIsThereTwiceUnderAnyName) {
  EXPECT_EQ(runs_refusal(run_a + R"(, {"file": "./a.csv", "kind": "transient", "role": "validate",
                                        "drive": "current"})"),
            "dataset.json: /runs/1/file: must not be there twice; got text \"./a.csv\"");
}

TEST_F(DatasetFiles, NameTheFileThatIsAtFault) {
  EXPECT_EQ(runs_refusal(R"({"file": "c.csv", "kind": "transient", "role": "fit", "drive": "current"})"),
            "c.csv: cannot be opened: No such file or directory");
  write("a.csv", "time_s,current_A,bending_angle_deg\n0,0,1\n0,1.4,2\n");
  EXPECT_EQ(
      runs_refusal(run_a),
      "a.csv: line 3: column time_s: must exceed the value before it (0); delete line 3, which repeats the time of the "
      "row above; got 0");
  // A validate run, too, must be a table.
  write("a.csv", step);
  write("b.csv", "time_s,current_A,bending_angle_deg\n0,0,1\n1,1.4\n");
  EXPECT_EQ(runs_refusal(run_a + "," + run_b),
            "b.csv: line 3: must have 3 fields, as the header has (delete the line if it is damaged); got 2");
  EXPECT_THAT(text::testing::error_of([&] { (void)read_dataset(folder_.path() / "nothing"); }),
              HasSubstr("nothing: cannot be opened: No such file or directory"));
}

// Runs that are held out too: what their errors are compared with must be angles of the rig.
TEST_F(DatasetFiles, RefuseAnglesThatNoFingerReachesInAnyRun) {
  const std::string absurd = "time_s,current_A,bending_angle_deg\n0,1,3000\n1,1,3000\n50,1,3000\n";
  const std::string rule =
      ".csv: line 2: column bending_angle_deg: must be within two turns, as no finger bends further (is the unit "
      "right?); got 3000";
  write("b.csv", absurd);
  EXPECT_EQ(runs_refusal(run_a + "," + run_b), "b" + rule);
  write("a.csv", absurd);
  EXPECT_EQ(runs_refusal(run_a + "," + run_b), "a" + rule);
}

TEST_F(DatasetFiles, WarnOfRunsThatLookWrong) {
  write("a.csv", "time_s,current_A,bending_angle_deg\n0,1.4,1\n0.01,1.4,2\n0.02,1.4,4.5\n0.03,1.4,6.5\n");
  const DatasetFile file = read_runs(run_a + "," + run_b);
  ASSERT_EQ(file.data.warnings.size(), 1u);
  EXPECT_EQ(file.data.warnings[0].run, "a.csv");
  EXPECT_THAT(file.data.warnings[0].text, HasSubstr("the input never moves"));
}

TEST_F(DatasetFiles, WarnOfACopyUnderAnotherName) {
  std::string record = "time_s,current_A,bending_angle_deg\n";
  for (int i = 0; i < 20; ++i) record += fmt::format("{},{},{}\n", 0.01 * i, i < 3 ? 0.0 : 1.4, 0.5 * i);
  write("a.csv", record);
  write("b.csv", record);
  const DatasetFile file = read_runs(run_a + "," + run_b);
  ASSERT_EQ(file.data.warnings.size(), 1u);
  EXPECT_EQ(file.data.warnings[0].run, "b.csv");
  EXPECT_THAT(file.data.warnings[0].text, HasSubstr("has the readings of a.csv, every one"));
}

const std::string seen = "time_s,bending_angle_deg\n0.1,1\n0.14,2\n0.16,4.5\n0.2,6.5\n";
const std::string run_c = R"({"file": "seen.csv", "kind": "transient", "role": "fit", "drive": "current",
                              "input_file": "fed.csv")";

TEST_F(DatasetFiles, ReadWhatALaboratoryKnowsOfItsClocksAndItsRig) {
  write("seen.csv", seen);
  write("fed.csv", "time_s,current_A\n0,0\n0.15,1.4\n0.3,1.4\n");
  write("still.csv", "# nothing moves\ntime_s,bending_angle_deg\n0,7.1\n1,7.2\n2,7\n");
  const DatasetFile file = read_runs(run_c + R"(, "input_hold": "unknown_within_sample", "clock_offset_s": 0.01,
      "clock_rate": 0.005, "exposure_s": 0.004, "rig": {"base_turn_deg": 90, "tip_mass_g": 5, "coil": "shorted"}},)" +
                                     run_b + R"(, {"file": "still.csv", "kind": "still", "role": "fit"})");
  ASSERT_EQ(file.data.fit.size(), 1u);
  const measurement::data::Run& run = file.data.fit[0];
  EXPECT_THAT(run.times, ElementsAre(0.1, 0.14, 0.16, 0.2));
  EXPECT_THAT(run.input_times, ElementsAre(0.0, 0.15, 0.3));
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.0), ElementsAre(1.4), ElementsAre(1.4)));
  EXPECT_EQ(run.samples(), 4u);
  EXPECT_EQ(run.hold, measurement::data::InputHold::unknown_within_sample);
  EXPECT_EQ(run.clock.offset_sigma, 0.01);
  EXPECT_EQ(run.clock.rate_sigma, 0.005);
  EXPECT_EQ(run.clock.exposure, 0.004);
  EXPECT_DOUBLE_EQ(run.rig.base_turn, 3.14159265358979323846 / 2.0);
  EXPECT_EQ(run.rig.tip_mass, 5e-3);
  EXPECT_EQ(run.rig.coil, measurement::data::CoilWiring::shorted);
  ASSERT_EQ(file.data.still.size(), 1u);
  EXPECT_EQ(file.data.still[0].name, "still.csv");
  EXPECT_THAT(file.data.warnings, IsEmpty());
  // The input's file is one of the set, which nothing may be written over.
  EXPECT_THAT(file.run_files, ::testing::Contains(folder_.path() / "fed.csv"));
}

TEST_F(DatasetFiles, SayHowFarAnInputIsFromWhatActed) {
  write("pushed.csv", "time_s,torque1_Nmm,torque2_Nmm,theta1_deg\n0,0,1,2\n0.01,5,4,3\n");
  const std::string pushed = R"({"file": "pushed.csv", "kind": "transient", "role": "fit", "drive": "torque")";
  const DatasetFile file = read(R"({"format": "measured-data/1", "input_sigma": 0.1, "input_correlation_s": 0.02,
      "runs": [)" + run_a + "," +
                                pushed + R"(, "input_sigma": [30, 40]},
      {"file": "bench.csv", "kind": "static_torque", "role": "fit"},)" +
                                run_b + "]}");
  ASSERT_EQ(file.data.fit.size(), 3u);
  EXPECT_EQ(file.data.fit[2].input_uncertainty, measurement::data::InputUncertainty{});
  EXPECT_EQ(file.data.fit[0].input_uncertainty,
            (measurement::data::InputUncertainty{.sigma = {0.1}, .correlation = 0.02}));
  EXPECT_THAT(file.data.fit[1].input_uncertainty.sigma, ElementsAre(0.03, 0.04));
  EXPECT_EQ(file.data.fit[1].input_uncertainty.correlation, 0.02);
  EXPECT_THAT(read_runs(pushed + R"(, "input_sigma": 30})").data.fit[0].input_uncertainty.sigma,
              ElementsAre(0.03, 0.03));
  EXPECT_EQ(runs_refusal(pushed + R"(, "input_sigma": [1, 2, 3]})"),
            "dataset.json: /runs/0: input_sigma must be one number, or one for each of the 2 columns of the input; got "
            "3 numbers");
  EXPECT_EQ(runs_refusal(pushed + R"(, "input_sigma": 0})"),
            "dataset.json: /runs/0/input_sigma: must be from 1e-12 to 1000000000000; got 0");
  EXPECT_EQ(runs_refusal(pushed + R"(, "input_correlation_s": 0.1})"),
            "dataset.json: /runs/0/input_correlation_s: must not be there without input_sigma, of whose errors it is "
            "the time");
  EXPECT_EQ(runs_refusal(R"({"file": "bench.csv", "kind": "static_torque", "role": "fit", "input_sigma": 0.1})"),
            "dataset.json: /runs/0/input_sigma: must be there for a transient only");
}

TEST_F(DatasetFiles, AssumeAShiftOfOneSampleBetweenTwoClocks) {
  write("seen.csv", seen);
  write("fed.csv", "time_ms,current_A\n0,0\n150,1.4\n300,1.4\n");
  EXPECT_DOUBLE_EQ(read_runs(run_c + "}").data.fit[0].clock.offset_sigma, 0.04);  // the median of 40, 20 and 40 ms
  EXPECT_EQ(read_runs(run_c + R"(, "clock_offset_s": 0})").data.fit[0].clock.offset_sigma, 0.0);
  EXPECT_EQ(read_runs(run_a).data.fit[0].clock.offset_sigma, 0.0);
}

TEST_F(DatasetFiles, MayShareAnInput) {
  write("seen.csv", seen);
  write("other.csv", seen);
  write("fed.csv", "time_s,current_A\n0,0\n0.15,1.4\n0.3,1.4\n");
  const DatasetFile file = read_runs(run_c + R"(}, {"file": "other.csv", "kind": "transient", "role": "validate",
                                                    "drive": "current", "input_file": "fed.csv"})");
  EXPECT_EQ(file.data.validate.count(), 1u);
}

TEST_F(DatasetFiles, RefuseAnInputThatDoesNotFitTheMeasurement) {
  write("seen.csv", seen);
  const auto fed = [&](std::string_view content) {
    write("fed.csv", content);
    return runs_refusal(run_c + R"(, "clock_offset_s": 0.005})");
  };
  EXPECT_EQ(
      fed("time_s,current_A\n0.13,0\n0.3,1.4\n"),
      "fed.csv: line 2: column time_s: must not begin after the measurement of seen.csv does (0.1 s); if the input was "
      "held there, repeat its first row with the time 0.1, else delete the rows of seen.csv before it; got 0.13");
  EXPECT_EQ(fed("time_s,current_A\n0.1,0\n0.12,0\n0.13,1.4\n"),
            "fed.csv: line 4: column time_s: must reach the end of the measurement of seen.csv (0.2 s) to within the "
            "longest interval of the input (0.02 s); if the input was held there, repeat its last row with the time "
            "0.2, else "
            "delete the rows of seen.csv after it; got 0.13");
  // Both cures, as they are told; and another unit, which either would hide.
  EXPECT_EQ(fed("time_s,current_A\n0.1,0\n0.12,0\n0.13,1.4\n0.2,1.4\n"), "accepted");
  EXPECT_THAT(fed("time_s,current_A\n100,0\n120,0\n300,1.4\n"),
              ::testing::HasSubstr("is one of them in another unit?"));
  EXPECT_EQ(fed("time_s,current_A,bending_angle_deg\n0,0,1\n0.3,1.4,2\n"),
            "fed.csv: line 1: column bending_angle_deg: is in seen.csv too; a column may be in one of the two only");
  EXPECT_EQ(
      fed("time_s,bending_deg\n0,0\n0.3,1.4\n"),
      "fed.csv: line 1: column bending_deg: unknown column; there may be time_s, current_A, current1_A.., "
      "voltage_V, torque1_Nm..; what is to be left alone is named in \"ignore\" in dataset.json, by name or position "
      "(\"#1\"); the columns are \"time_s\", \"bending_deg\", and dataset.json must say the input: a column of current "
      "or voltage in this file, or another file with one, named by \"input_file\"; or \"kind\": \"still\" if nothing "
      "moves in it; the rest is \"ignore\": "
      "[\"bending_deg\"]");
  EXPECT_EQ(
      fed("time_s\n0\n0.3\n"),
      "fed.csv: line 1: must have an input column: current_A, current1_A.., voltage_V or torque1_Nm..; the columns are "
      "\"time_s\", and dataset.json must say the input: a column of current or voltage in this file, or another file "
      "with one, named by \"input_file\"; or \"kind\": \"still\" if nothing moves in it");
  write("seen.csv", step);
  EXPECT_EQ(fed("time_s,current_A\n0,0\n0.3,1.4\n"),
            "seen.csv: line 1: must have no input column, because the run's \"input_file\" has the input");
  write("seen.csv", seen);
  EXPECT_EQ(runs_refusal(R"({"file": "seen.csv", "kind": "transient", "role": "fit", "drive": "voltage",
                             "input_file": "fed.csv"})"),
            "dataset.json: /runs/0/drive: must be \"current\", as the input column of the file says; got text "
            "\"voltage\"");
}

TEST_F(DatasetFiles, RefuseWhatNoRecordingHas) {
  const auto with = [&](const std::string& key) {
    return runs_refusal(R"({"file": "a.csv", "kind": "transient", "role": "fit", "drive": "current", )" + key + "}");
  };
  EXPECT_EQ(with(R"("input_hold": "first_order")"),
            R"(dataset.json: /runs/0/input_hold: must be one of "zero_order", "linear", "unknown_within_sample"; got )"
            R"(text "first_order")");
  EXPECT_EQ(with(R"("clock_offset_s": -0.1)"),
            "dataset.json: /runs/0/clock_offset_s: must be from 0 to 100000; got -0.1");
  EXPECT_EQ(with(R"("clock_rate": 2)"), "dataset.json: /runs/0/clock_rate: must be from 0 to 1; got 2");
  EXPECT_EQ(with(R"("exposure_s": 0.03)"),
            "dataset.json: /runs/0/exposure_s: must be shorter than the record; got 0.03");
  EXPECT_EQ(with(R"("rig": {"tip_mass_g": -5})"),
            "dataset.json: /runs/0/rig/tip_mass_g: must be from 0 to 1000000; got -5");
  EXPECT_EQ(with(R"("rig": {"coil": "closed"})"),
            R"(dataset.json: /runs/0/rig/coil: must be one of "driven", "open", "shorted"; got text "closed")");
  EXPECT_EQ(with(R"("rig": {"base_turn": 3})"),
            R"(dataset.json: /runs/0/rig/base_turn: unknown key; did you mean "base_turn_deg"?)");
  EXPECT_EQ(with(R"("ignore": ["a", "a"])"), "dataset.json: /runs/0/ignore/1: must not be there twice; got text \"a\"");
  EXPECT_EQ(runs_refusal(R"({"file": "bench.csv", "kind": "static_torque", "role": "fit", "exposure_s": 0.1})"),
            "dataset.json: /runs/0/exposure_s: must be there for a transient only");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "still", "role": "validate"})"),
            "dataset.json: /runs/0/role: must be \"fit\": every run uses a still run, and none is held out; got text "
            "\"validate\"");
  EXPECT_EQ(runs_refusal(R"({"file": "a.csv", "kind": "still"})"), "dataset.json: /runs: needs at least one fit run");
}

TEST_F(DatasetFiles, SayHowWellTheirNumbersAreKnown) {
  const auto tolerances = [&](const std::string& value) {
    return read(R"({"format": "measured-data/1", "tolerances": )" + value + R"(, "runs": [)" + run_a + "]}").tolerances;
  };
  EXPECT_FALSE(read_runs(run_a).tolerances.others_exact);
  EXPECT_THAT(read_runs(run_a).tolerances.named, IsEmpty());
  EXPECT_TRUE(tolerances("\"exact\"").others_exact);
  const Tolerances some = tolerances(R"({"/measured/tip_segment_mass_g": 0.5, "force_curve": 0})");
  EXPECT_FALSE(some.others_exact);
  ASSERT_EQ(some.named.size(), 2u);
  EXPECT_EQ(some.named[0].name, "/measured/tip_segment_mass_g");
  EXPECT_EQ(some.named[0].deviation, 0.5);
  EXPECT_EQ(some.named[1].deviation, 0.0);
  const auto wrong = [&](const std::string& value) {
    return refusal(R"({"format": "measured-data/1", "tolerances": )" + value + R"(, "runs": [)" + run_a + "]}");
  };
  EXPECT_EQ(wrong("\"none\""), "dataset.json: /tolerances: must be \"exact\" or an object; got text \"none\"");
  EXPECT_EQ(wrong(R"({"/links/0/mass_kg": -1})"),
            "dataset.json: /tolerances/~1links~10~1mass_kg: must be >= 0; got -1");
  EXPECT_EQ(
      wrong(R"({"mass": 1})"),
      R"(dataset.json: /tolerances/mass: must be called "force_curve", "force_curve_0", "joint_stiffness_ratio", )"
      R"("joint_damping_ratio", "face_closing_deg", "joint_stiffness", "joint_damping" or by a JSON pointer into the actuator file)");
}

// Blocks of docs/formats-dataset.md that begin ```<kind>, by what else is on that line.
std::map<std::string, std::string> documented(const std::string& kind) {
  std::ifstream file(COILWRIGHT_SOURCE_DIR "/docs/formats-dataset.md");
  std::map<std::string, std::string> blocks;
  std::string opening("```");
  opening.append(kind).push_back(' ');
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(opening)) continue;
    std::string& block = blocks[line.substr(opening.size())];
    for (std::string inside; std::getline(file, inside) && inside != "```";) block.append(inside).push_back('\n');
  }
  return blocks;
}

TEST_F(DatasetFiles, OfTheDocumentAreLegal) {
  const auto runs = documented("csv");
  EXPECT_EQ(runs.size(), 3u);
  for (const auto& [name, text] : runs) write(name, text);
  const DatasetFile file = read(documented("json").at("dataset"));
  EXPECT_EQ(file.data.fit.size(), 2u);
  EXPECT_EQ(file.data.validate.count(), 1u);
  EXPECT_THAT(file.data.warnings, IsEmpty());
  // Its names mean numbers of the actuator it names, which it looks for beside the document.
  EXPECT_EQ(file.actuator->filename(), "paper_finger.json");
  const DeclaredActuator actuator = read_declared_actuator(COILWRIGHT_SOURCE_DIR "/configs/actuators/paper_finger.json",
                                                           {.names = file.calibrate, .file = file.file});
  EXPECT_EQ(actuator.model.calibration.size(), 3u);
}

TEST_F(DatasetFiles, OfOtherProgramsInTheDocumentAreRead) {
  for (const auto& [name, text] : documented("text")) write(name, text);
  const auto sets = documented("json");
  const auto run_of = [&](const char* kind) { return read(sets.at(kind)).data.fit.at(0); };
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const auto labview = run_of("labview");
  EXPECT_THAT(labview.times, ElementsAre(0.0, 0.002, 0.004));
  EXPECT_THAT(labview.inputs, ElementsAre(ElementsAre(0.0), ElementsAre(1.4), ElementsAre(1.4)));
  EXPECT_DOUBLE_EQ(labview.channels[0].values[2], -8.2 * degree);
  const auto scope = run_of("oscilloscope");
  EXPECT_THAT(scope.times, ElementsAre(-0.002, 0.0, 0.002));
  EXPECT_NEAR(scope.inputs[1][0], 1.4, 1e-15);
  EXPECT_NEAR(scope.channels[0].values[0], 7.2 * degree, 1e-15);
  const auto film = run_of("deeplabcut");
  EXPECT_NEAR(film.channels[0].values[2], std::atan2(14.0, 98.5), 1e-15);
  EXPECT_THAT(film.times, ElementsAre(0.0, 1.0 / 240.0, 2.0 / 240.0));
  EXPECT_THAT(film.input_times, ElementsAre(0.0, ::testing::DoubleEq(0.004), ::testing::DoubleEq(0.010)));
  const auto arduino = run_of("arduino");
  EXPECT_NEAR(arduino.inputs[1][0], 12.0, 1e-4);
  EXPECT_NEAR(arduino.channels[0].values[0], -0.9 * degree, 1e-14);
  EXPECT_NEAR(arduino.channels[0].values[2], 1.4 * degree, 1e-14);
}

TEST(EffectsOfTheDocument, AreThoseOfTheCatalogue) {
  std::ifstream file(COILWRIGHT_SOURCE_DIR "/docs/theory/effects.md");
  std::vector<std::string> rows;  // of its tables of effects, one a stage
  bool in_table = false;
  for (std::string line; std::getline(file, line);) {
    in_table = line.starts_with("| id | equation |") || (in_table && line.starts_with("|"));
    if (in_table && line.starts_with("| `")) rows.push_back(line);
  }
  ASSERT_EQ(rows.size(), actuator::standard_effects().kinds().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const actuator::EffectKind& kind = *actuator::standard_effects().kinds()[i];
    EXPECT_THAT(rows[i], HasSubstr(std::string("| `").append(kind.id()).append("` |")));
    for (const actuator::EffectParameter& parameter : kind.parameters())
      EXPECT_THAT(rows[i], HasSubstr(std::string("`").append(parameter.key).append("`")));
  }
}

}  // namespace
}  // namespace coilwright::formats
