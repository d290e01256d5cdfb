#include "coilwright/formats/data/run_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "degree.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using measurement::data::ChannelKind;
using measurement::data::Drive;
using measurement::data::RunKind;
using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

measurement::data::Run run_of(std::string_view text, const RunEntry& entry) {
  return parse_run(text, "x.csv", entry).run;
}

measurement::data::Run run_of(std::string_view text, RunKind kind) {
  return run_of(text, RunEntry{.name = "x.csv", .kind = kind});
}

// Without what it says to write into dataset.json, for which layout_test.cpp is.
std::string run_refusal(std::string_view text, RunKind kind = RunKind::transient) {
  const std::string error = text::testing::error_of([&] { (void)run_of(text, kind); });
  return error.substr(0, std::min(error.find("; in dataset.json, "), error.find("; the columns are ")));
}

std::string objection(std::string_view text, RunKind kind = RunKind::transient) {
  const auto found = parse_run(text, "x.csv", {.name = "x.csv", .kind = kind}).objection;
  return found ? found->error.what() : "none";
}

TEST(RunFile, ReadsEveryMeasuredColumnOfATransient) {
  const auto run = run_of(
      "time_s,current1_A,current2_A,theta1_deg,theta2_rad,omega1_deg_s,bending_angle_deg\n"
      "0.1,1.4,-0.7,30,0.2,90,41.5\n0.35,1.3,-0.6,33,0.25,45,47.5\n",
      RunKind::transient);
  EXPECT_EQ(run.drive, Drive::current);
  EXPECT_THAT(run.times, ElementsAre(0.1, 0.35));
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(1.4, -0.7), ElementsAre(1.3, -0.6)));
  ASSERT_EQ(run.channels.size(), 4u);
  EXPECT_EQ(run.channels[0].name, "bending_angle_deg");
  EXPECT_EQ(run.channels[0].kind, ChannelKind::bending_angle);
  EXPECT_THAT(run.channels[0].values, ElementsAre(DoubleEq(41.5 * degree), DoubleEq(47.5 * degree)));
  EXPECT_EQ(run.channels[2].name, "theta2_rad");
  EXPECT_EQ(run.channels[2].kind, ChannelKind::joint_angle);
  EXPECT_EQ(run.channels[2].joint, 1);
  EXPECT_THAT(run.channels[2].values, ElementsAre(0.2, 0.25));
  EXPECT_EQ(run.channels[3].kind, ChannelKind::joint_rate);
  EXPECT_THAT(run.channels[3].values, ElementsAre(DoubleEq(90.0 * degree), DoubleEq(45.0 * degree)));
  EXPECT_EQ(run.samples(), 2u);
}

TEST(RunFile, KnowsTheDriveByTheInputColumn) {
  EXPECT_EQ(run_of("time_s,voltage_V,omega1_rad_s\n0,1,2\n1,1,3\n", RunKind::transient).drive, Drive::voltage);
  const auto run = run_of("time_s,torque1_Nmm,theta1_rad\n0,250,2\n1,251,3\n", RunKind::transient);
  EXPECT_EQ(run.drive, Drive::torque);
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.25), ElementsAre(0.251)));
}

TEST(RunFile, ReadsTheBenches) {
  auto run = run_of("angle_deg,current_A,torque_Nmm\n30,1.4,17.5\n", RunKind::static_torque);
  EXPECT_THAT(run.angles, ElementsAre(DoubleEq(30.0 * degree)));
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(1.4)));
  EXPECT_THAT(run.channels[0].values, ElementsAre(0.0175));
  EXPECT_THAT(run.times, IsEmpty());
  run = run_of("torque_Nm,angle_rad\n0.0175,0.6\n", RunKind::joint_stiffness);
  EXPECT_THAT(run.angles, ElementsAre(0.6));
  EXPECT_EQ(run.channels[0].kind, ChannelKind::torque);
  EXPECT_THAT(run.channels[0].values, ElementsAre(0.0175));
  EXPECT_THAT(run.inputs, IsEmpty());
  run = run_of("current_A,force_N\n0.9,0.135\n1.4,0.21\n", RunKind::blocked_force);
  EXPECT_EQ(run.channels[0].kind, ChannelKind::force);
  EXPECT_THAT(run.inputs, ElementsAre(ElementsAre(0.9), ElementsAre(1.4)));
  EXPECT_THAT(run.channels[0].values, ElementsAre(0.135, 0.21));
}

TEST(RunFile, KeepsTemperaturesInDegreesCelsius) {
  const auto run =
      run_of("time_s,current_A,temperature_degC\n0,0.7,23.4\n0.7,0.7,23.6\n2,0.7,24.1\n", RunKind::temperature);
  EXPECT_EQ(run.channels[0].kind, ChannelKind::temperature);
  EXPECT_THAT(run.channels[0].values, ElementsAre(23.4, 23.6, 24.1));
  EXPECT_THAT(run.times, ElementsAre(0.0, 0.7, 2.0));
}

TEST(RunFile, TakesSigmaInTheUnitOfTheFirstAngle) {
  const auto sigma = [](std::string_view text, RunKind kind) {
    return *run_of(text, RunEntry{.name = "x", .kind = kind, .sigma = 0.3}).sigma;
  };
  EXPECT_DOUBLE_EQ(sigma("time_s,current_A,omega1_rad_s,theta1_deg\n0,1,2,3\n1,1,2,3\n", RunKind::transient),
                   0.3 * degree);
  EXPECT_DOUBLE_EQ(sigma("time_s,current_A,omega1_deg_s\n0,1,2\n1,1,2\n", RunKind::transient), 0.3 * degree);
  EXPECT_DOUBLE_EQ(sigma("angle_deg,current_A,torque_Nmm\n30,1.4,17.5\n", RunKind::static_torque), 0.3e-3);
  EXPECT_DOUBLE_EQ(sigma("time_s,current_A,temperature_degC\n0,0,1\n1,0,1\n", RunKind::temperature), 0.3);
}

TEST(RunFile, ReadsWhereAGraspWasMeasured) {
  const auto run =
      run_of("current_A,opening_deg,height_mm,force_N\n0.9,0,12,0.135\n1.4,60,9,0.21\n", RunKind::blocked_force);
  EXPECT_THAT(run.openings, ElementsAre(0.0, DoubleEq(60.0 * degree)));
  EXPECT_THAT(run.heights, ElementsAre(DoubleEq(12e-3), DoubleEq(9e-3)));
  EXPECT_THAT(run_of("current_A,force_N\n0.9,0.135\n", RunKind::blocked_force).openings, IsEmpty());
  EXPECT_EQ(run_refusal("current_A,opening_deg,force_N\n0.9,-3,0.135\n", RunKind::blocked_force),
            "x.csv: line 2: column opening_deg: must be >= 0; got -3");
}

TEST(RunFile, ReadsAStillRunWithoutAnInput) {
  const auto run = run_of("time_ms,current_A,theta1_deg\n0,0,7.1\n2,0,7.2\n", RunKind::still);
  EXPECT_EQ(run.kind, RunKind::still);
  EXPECT_THAT(run.times, ElementsAre(0.0, 0.002));
  EXPECT_THAT(run.inputs, IsEmpty());
  EXPECT_THAT(run.channels[0].values, ElementsAre(DoubleEq(7.1 * degree), DoubleEq(7.2 * degree)));
  EXPECT_EQ(run_refusal("time_s,current_A\n0,0\n1,0\n", RunKind::still),
            "x.csv: line 1: must have a measured column: bending_angle_deg, theta1_deg.. or omega1_rad_s..");
}

TEST(RunFile, NeedsNoInputWhereNoDriverIsConnected) {
  using measurement::data::CoilWiring;
  const auto run = [](std::string_view text, CoilWiring coil) {
    return run_of(text, RunEntry{.name = "x.csv", .kind = RunKind::transient, .rig = {.coil = coil}});
  };
  EXPECT_THAT(run("time_s,theta1_deg\n0,7\n1,6\n", CoilWiring::open).inputs,
              ElementsAre(ElementsAre(0.0), ElementsAre(0.0)));
  EXPECT_EQ(run("time_s,theta1_deg\n0,7\n1,6\n", CoilWiring::shorted).rig.coil, CoilWiring::shorted);
  EXPECT_THAT(run("time_s,current_A,theta1_deg\n0,0.5,7\n1,0.5,6\n", CoilWiring::open).inputs,
              ElementsAre(ElementsAre(0.5), ElementsAre(0.5)));
  EXPECT_EQ(
      text::testing::error_of([&] { (void)run("time_s,curent_A,theta1_deg\n0,0,7\n1,0,6\n", CoilWiring::open); }),
      "x.csv: line 1: column curent_A: unknown column; did you mean \"current_A\"?; in dataset.json, beside \"runs\" "
      "for all runs, write: \"columns\": {\"curent_A\": \"current_A\"}");
}

TEST(RunFile, LeavesColumnsAloneThatTheSetNames) {
  const RunEntry entry{.name = "x.csv",
                       .kind = RunKind::transient,
                       .layout = {.layout = {.ignore = {"frame", "theta1_deg"}}, .must_fit = {{"frame", "ignore"}}}};
  const auto run = run_of("frame,time_s,current_A,bending_angle_deg,theta1_deg\na,0,1,2,\nb,1,1,3,x\n", entry);
  ASSERT_EQ(run.channels.size(), 1u);
  EXPECT_EQ(run.channels[0].name, "bending_angle_deg");
  EXPECT_EQ(text::testing::error_of([&] { (void)run_of("time_s,current_A,theta1_deg\n0,1,2\n1,1,3\n", entry); }),
            "x.csv: line 1: column frame: is not there, and the run's \"ignore\" names it; the columns are \"time_s\", "
            "\"current_A\", \"theta1_deg\"");
}

TEST(RunFile, RefusesMissingColumns) {
  EXPECT_EQ(run_refusal("current_A,theta1_deg\n1,2\n"), "x.csv: line 1: column time_s: is missing");
  EXPECT_EQ(run_of("Bench of May,run 3\ntime_s,current_A,theta1_deg\n0,1,2\n1,1,2\n", RunKind::transient).samples(),
            2u);
  EXPECT_EQ(run_refusal("time_s,current_A\n1,2\n"),
            "x.csv: line 1: must have a measured column: bending_angle_deg, theta1_deg.. or omega1_rad_s..");
  EXPECT_EQ(run_refusal("time_s,theta1_deg\n1,2\n"),
            "x.csv: line 1: must have an input column: current_A, current1_A.., voltage_V or torque1_Nm..");
  EXPECT_EQ(run_refusal("angle_deg,torque_Nmm\n1,2\n", RunKind::static_torque),
            "x.csv: line 1: column current_A: is missing");
  EXPECT_EQ(run_refusal("angle_deg,force_N\n1,2\n", RunKind::joint_stiffness),
            "x.csv: line 1: column torque_Nmm: is missing");
  EXPECT_EQ(run_refusal("current_A,torque_Nmm\n1,2\n", RunKind::blocked_force),
            "x.csv: line 1: column force_N: is missing");
  EXPECT_EQ(run_refusal("time_s,current_A\n1,2\n", RunKind::temperature),
            "x.csv: line 1: column temperature_degC: is missing");
}

TEST(RunFile, RefusesColumnsAndUnitsThatDoNotExist) {
  EXPECT_EQ(run_refusal("time_s,current_A,bending_angel_deg\n1,2,3\n"),
            "x.csv: line 1: column bending_angel_deg: unknown column; did you mean \"bending_angle_deg\"?");
  EXPECT_EQ(
      run_refusal("time_A,current_A,theta1_deg\n1,2,3\n"),
      "x.csv: line 1: column time_A: unknown unit; may be \"time_s\" or \"time_ms\" or \"time_us\" or \"time_ns\" or "
      ".., with the numbers in that unit");
  EXPECT_EQ(
      run_refusal("time_s,current_A,theta1_mm\n1,2,3\n"),
      "x.csv: line 1: column theta1_mm: unknown unit; may be \"theta1_rad\" or \"theta1_mrad\" or \"theta1_deg\", "
      "with the numbers in that unit");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg,theta3_deg\n1,2,3,4\n"),
            "x.csv: line 1: column theta3_deg: unknown column; did you mean \"theta2_deg\"?");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg,theta1_rad\n1,2,3,4\n"),
            "x.csv: line 1: column theta1_rad: must not be there twice");
  EXPECT_EQ(run_refusal("time_s,current_A,voltage_V,theta1_deg\n1,2,3,4\n"),
            "x.csv: line 1: must have one kind of input only (current_A, current1_A.., voltage_V, torque1_Nm..)");
  EXPECT_EQ(run_refusal("angle_deg,current_A,torque_Nmm,force_N\n1,2,3,4\n", RunKind::static_torque),
            "x.csv: line 1: column force_N: unknown column; there may be angle_deg, current_A, torque_Nmm; what is to "
            "be left "
            "alone is named in \"ignore\" in dataset.json, by name or position (\"#1\")");
}

TEST(RunFile, RefusesWhatIsNotATableOfNumbers) {
  EXPECT_EQ(run_refusal(""), "x.csv: is empty: it must have a header");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg\n"), "x.csv: must have a row below its header");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg\n0,1,2\n1,1\n"),
            "x.csv: line 3: must have 3 fields, as the header has (delete the line if it is damaged); got 2");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg\n0,1,2\n1,1,2,3\n"),
            "x.csv: line 3: must have 3 fields, as the header has (are its decimals written with commas?); got 4");
  EXPECT_EQ(
      run_refusal("time_s,current_A,theta1_deg\n0,1,2\n1,1,abc\n"),
      "x.csv: line 3: column theta1_deg: must be a finite number (delete the line if it is damaged); got \"abc\"");
  EXPECT_EQ(
      run_refusal("time_s,current_A,temperature_degC\n0,1,2\n1,1,nan\n", RunKind::temperature),
      "x.csv: line 3: column temperature_degC: must be a finite number (delete the rows that have none); got \"nan\"");
  EXPECT_EQ(
      run_refusal("time_s,current_A,theta1_deg\n0,1,2\n1,-inf,2\n"),
      "x.csv: line 3: column current_A: must be a finite number (delete the line if it is damaged); got \"-inf\"");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg\n0,1,\n1,1,\n"),
            "x.csv: line 2: column theta1_deg: must have at least two values in the file; got nan");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg\n0,1,2\n1,1e13,2\n"),
            "x.csv: line 3: column current_A: must be a number that can be measured, at most 1e12; got 10000000000000");
}

TEST(RunFile, RefusesATimeThatGoesBackOrStandsStill) {
  EXPECT_EQ(
      run_refusal("time_s,current_A,theta1_deg\n0.1,1,2\n0.3,1,2\n0.2,1,2\n"),
      "x.csv: line 4: column time_s: must exceed the value before it (0.3); the clock starts again here, so the "
      "file holds 2 records: make a file of each, with the line of names, and a run of each in dataset.json; got 0.2");
  EXPECT_EQ(
      run_refusal("time_s,current_A,temperature_degC\n0.1,1,2\n0.1,1,2\n", RunKind::temperature),
      "x.csv: line 3: column time_s: must exceed the value before it (0.1); delete line 3, which repeats the time "
      "of the row above; got 0.1");
  EXPECT_EQ(run_refusal("time_s,current_A,theta1_deg\n0.1,1,2\n"),
            "x.csv: line 2: column time_s: must be followed by a second sample; got 0.1");
}

TEST(RunFile, ObjectsToAnAngleThatNoFingerReaches) {
  EXPECT_EQ(objection("time_s,current_A,theta1_deg\n0,1,2\n1,1,3000\n"),
            "x.csv: line 3: column theta1_deg: must be within two turns, as no finger bends further (is the unit "
            "right?); got 3000");
  EXPECT_EQ(objection("time_s,voltage_V,bending_angle_rad\n0,1,-60\n1,1,3\n"),
            "x.csv: line 2: column bending_angle_rad: must be within two turns, as no finger bends further (is the "
            "unit right?); got -60");
  EXPECT_EQ(objection("angle_deg,torque_Nmm\n3000,2\n", RunKind::joint_stiffness),
            "x.csv: line 2: column angle_deg: must be within two turns, as no finger bends further (is the unit "
            "right?); got 3000");
  EXPECT_EQ(objection("time_s,torque1_Nm,theta1_deg\n0,1,2\n1,1,3000\n"), "none");  // a pendulum may turn
  EXPECT_EQ(objection("time_s,current_A,omega1_deg_s\n0,1,2\n1,1,3000\n"), "none");
}

}  // namespace
}  // namespace coilwright::formats
