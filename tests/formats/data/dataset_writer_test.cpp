
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "coilwright/formats/data/dataset_file.hpp"
#include "degree.hpp"
#include "temporary_folder.hpp"

namespace coilwright::formats {
namespace {

using namespace measurement;
using ::testing::HasSubstr;

data::Run motion() {
  data::Run run{
      .name = "step.csv", .kind = data::RunKind::transient, .drive = data::Drive::current, .start = data::Start::free};
  for (int i = 0; i < 8; ++i) {
    run.times.push_back(i / 500.0);
    run.inputs.push_back({i < 2 ? 0.0 : 1.4, 0.0});
  }
  run.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle},
                  {.name = "omega1_rad_s", .kind = data::ChannelKind::joint_rate}};
  for (int i = 0; i < 8; ++i) {
    run.channels[0].values.push_back((30.0 + 0.02 * i) * degree);
    run.channels[1].values.push_back(-0.5 * i);
  }
  return run;
}

data::Run bench_run() {
  return {.name = "bench.csv",
          .kind = data::RunKind::static_torque,
          .angles = {0.0, 20 * degree},
          .inputs = {{1.4}, {1.4}},
          .channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque, .values = {0.0251, 0.0123}}}};
}

data::Run heat() {
  return {.name = "heat.csv",
          .kind = data::RunKind::temperature,
          .times = {0.0, 1.0},
          .inputs = {{1.0}, {1.0}},
          .channels = {{.name = "temperature_degC", .kind = data::ChannelKind::temperature, .values = {25.0, 25.5}}}};
}

std::string table_of(const data::Run& run) {
  std::ostringstream out;
  write_run(out, run);
  return out.str();
}

std::string entry(const data::Run& run) {
  const std::vector<RunWithRole> runs = {{.run = run}};
  return dataset_json("words", "actuator.json", runs).text();
}

TEST(DatasetWriter, WritesReadingsAsAnInstrumentShowsThem) {
  const std::string text = table_of(motion());
  EXPECT_TRUE(
      text.starts_with("time_s,current1_A,current2_A,bending_angle_deg,omega1_rad_s\n"
                       "0,0,0,30,0\n"
                       "0.002,0,0,30.02,-0.5\n"
                       "0.004,1.4,0,30.04,-1\n"
                       "0.006,1.4,0,30.06,-1.5\n"))
      << text;
  EXPECT_EQ(table_of(bench_run()), "angle_deg,current_A,torque_Nmm\n0,1.4,25.1\n20,1.4,12.3\n");
  EXPECT_EQ(table_of(heat()), "time_s,current_A,temperature_degC\n0,1,25\n1,1,25.5\n");
}

TEST(DatasetWriter, WritesASetThatIsReadBack) {
  const auto fit = motion();
  const auto other = bench_run();
  auto torque = motion();
  torque.name = "torque.csv";
  torque.drive = data::Drive::torque;
  torque.window = 0.01;
  torque.sigma = 0.3 * degree;
  const ::coilwright::testing::TemporaryFolder folder;
  const std::vector<RunWithRole> runs = {{.run = fit}, {.run = torque}, {.run = other, .validate = true}};
  const auto set = folder.file("dataset.json", dataset_json("a twin", "actuator.json", runs).text());
  for (const RunWithRole& each : runs) (void)folder.file(each.run.name, table_of(each.run));
  const formats::DatasetFile back = formats::read_dataset(set);
  EXPECT_EQ(back.data.name, "a twin");
  EXPECT_EQ(back.actuator, folder.path() / "actuator.json");
  EXPECT_EQ(back.data.validate.count(), 1u);
  ASSERT_EQ(back.data.fit.size(), 2u);
  const auto& read = back.data.fit[0];
  EXPECT_EQ(read.name, "step.csv");
  EXPECT_EQ(read.start, data::Start::free);
  EXPECT_EQ(read.times, fit.times);
  EXPECT_EQ(read.inputs, fit.inputs);
  ASSERT_EQ(read.channels.size(), 2u);
  // Twelve digits were written.
  for (std::size_t i = 0; i < fit.samples(); ++i)
    EXPECT_NEAR(read.channels[0].values[i], fit.channels[0].values[i], 1e-12) << i;
  EXPECT_EQ(read.channels[1].values, fit.channels[1].values);
  EXPECT_EQ(back.data.fit[1].drive, data::Drive::torque);
  EXPECT_EQ(back.data.fit[1].window, 0.01);
  EXPECT_NEAR(back.data.fit[1].sigma.value(), 0.3 * degree, 1e-15);
}

TEST(DatasetWriter, HasTheWordOfTheFormatForEachKindDriveAndStart) {
  EXPECT_THAT(entry({.kind = data::RunKind::transient}), HasSubstr(R"("kind": "transient")"));
  EXPECT_THAT(entry({.kind = data::RunKind::static_torque}), HasSubstr(R"("kind": "static_torque")"));
  EXPECT_THAT(entry({.kind = data::RunKind::joint_stiffness}), HasSubstr(R"("kind": "joint_stiffness")"));
  EXPECT_THAT(entry({.kind = data::RunKind::blocked_force}), HasSubstr(R"("kind": "blocked_force")"));
  EXPECT_THAT(entry({.kind = data::RunKind::temperature}), HasSubstr(R"("kind": "temperature")"));
  EXPECT_THAT(entry({.drive = data::Drive::current}), HasSubstr(R"("drive": "current")"));
  EXPECT_THAT(entry({.drive = data::Drive::voltage}), HasSubstr(R"("drive": "voltage")"));
  EXPECT_THAT(entry({.drive = data::Drive::torque}), HasSubstr(R"("drive": "torque")"));
  EXPECT_THAT(entry({.start = data::Start::at_rest}), HasSubstr(R"("start": "at_rest")"));
  EXPECT_THAT(entry({.start = data::Start::measured}), HasSubstr(R"("start": "measured")"));
  EXPECT_THAT(entry({.start = data::Start::free}), HasSubstr(R"("start": "free")"));
}

TEST(DatasetWriter, WritesClocksAndRigsThatReadBack) {
  data::Run run = motion();
  run.input_times = {-0.01, 0.003, 0.0164, 0.03};
  run.inputs = {{0.0, 0.1}, {1.4, 0.1}, {1.4, 0.2}, {1.4, 0.2}};
  run.hold = data::InputHold::linear;
  run.clock = {.offset_sigma = 0.004, .rate_sigma = 0.001, .exposure = 0.0015};
  run.input_uncertainty = {.sigma = {0.02, 0.03}, .correlation = 0.1};
  run.rig = {.base_turn = -30.0 * degree, .tip_mass = 5e-3, .coil = data::CoilWiring::shorted};
  const data::Run still{
      .name = "still.csv",
      .kind = data::RunKind::still,
      .times = {0.0, 0.1},
      .channels = {{.name = "theta1_deg", .kind = data::ChannelKind::joint_angle, .values = {0.1, 0.2}}}};
  EXPECT_EQ(input_file_name(run), "step_input.csv");
  EXPECT_FALSE(input_file_name(still));

  const coilwright::testing::TemporaryFolder folder;
  const std::vector<RunWithRole> runs = {{.run = run}, {.run = still}};
  const auto path = folder.file("dataset.json", dataset_json("x", "a.json", runs).text());
  folder.file("step.csv", table_of(run));
  folder.file("still.csv", table_of(still));
  std::ostringstream input;
  write_input(input, run);
  folder.file("step_input.csv", input.str());
  const data::Dataset back = read_dataset(path).data;
  ASSERT_EQ(back.fit.size(), 1u);
  EXPECT_EQ(back.fit[0].input_times, run.input_times);
  EXPECT_EQ(back.fit[0].inputs, run.inputs);
  EXPECT_EQ(back.fit[0].times, run.times);
  EXPECT_EQ(back.fit[0].hold, run.hold);
  EXPECT_EQ(back.fit[0].clock.offset_sigma, 0.004);
  EXPECT_EQ(back.fit[0].clock.rate_sigma, 0.001);
  EXPECT_EQ(back.fit[0].clock.exposure, 0.0015);
  EXPECT_EQ(back.fit[0].input_uncertainty, run.input_uncertainty);
  EXPECT_EQ(back.fit[0].rig, run.rig);
  ASSERT_EQ(back.still.size(), 1u);
  EXPECT_EQ(back.still[0].times, still.times);
}

}  // namespace
}  // namespace coilwright::formats
