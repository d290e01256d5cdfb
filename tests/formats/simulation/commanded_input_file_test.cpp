#include "coilwright/formats/simulation/commanded_input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using simulation::Addressing;
using simulation::CommandedInput;
using simulation::Drive;
using ::testing::ElementsAre;

std::string refusal(std::string_view text) {
  return text::testing::error_of([&] { (void)parse_commanded_input(text, "x.csv"); });
}

TEST(CommandedInput, CommandsAllCoilsByOneColumn) {
  const coilwright::testing::TemporaryFolder folder;
  const CommandedInput command = read_commanded_input(folder.file("x.csv", "time_s,current_A\n0.1,1.4\n0.35,-0.7\n"));
  EXPECT_EQ(command.drive, Drive::current);
  EXPECT_EQ(command.addressing, Addressing::common);
  EXPECT_THAT(command.times, ElementsAre(0.1, 0.35));
  EXPECT_THAT(command.rows, ElementsAre(ElementsAre(1.4), ElementsAre(-0.7)));
}

TEST(CommandedInput, CommandsEachJointByAColumnOfItsOwn) {
  const CommandedInput command =
      parse_commanded_input("torque2_Nmm,time_s,torque1_Nm\n9.9,0.1,2.5\n4.35,0.2,3.5\n", "x.csv");
  EXPECT_EQ(command.drive, Drive::torque);
  EXPECT_EQ(command.addressing, Addressing::each);
  EXPECT_THAT(command.rows, ElementsAre(ElementsAre(2.5, 0.0099), ElementsAre(3.5, 0.00435)));
}

TEST(CommandedInput, LeavesMeasuredColumnsAside) {
  const CommandedInput command =
      parse_commanded_input("time_s,voltage_V,theta1_rad,omega1_deg_s,bending_angle_deg\n0.5,2.5,3,4,5\n", "x.csv");
  EXPECT_EQ(command.drive, Drive::voltage);
  EXPECT_THAT(command.rows, ElementsAre(ElementsAre(2.5)));
}

TEST(CommandedInput, RefusesAMissingOrMisspeltInput) {
  EXPECT_EQ(refusal("time_s,theta1_deg\n1,2\n"),
            "x.csv: line 1: must have an input column: current_A, current1_A.., voltage_V or torque1_Nm..");
  EXPECT_EQ(refusal("time_s,curent_A\n1,2\n"),
            "x.csv: line 1: column curent_A: unknown column; did you mean \"current_A\"?");
  EXPECT_EQ(
      refusal("time_s,current_mV\n1,2\n"),
      "x.csv: line 1: column current_mV: unknown unit; may be \"current_A\" or \"current_mA\", with the numbers in "
      "that unit");
  EXPECT_EQ(refusal("current_A\n2\n"), "x.csv: line 1: column time_s: is missing");
  EXPECT_EQ(refusal("time_s,torque_Nm\n1,2\n"),
            "x.csv: line 1: column torque_Nm: unknown column; did you mean \"torque1_Nm\"?");
}

TEST(CommandedInput, RefusesTwoKindsOfInput) {
  EXPECT_EQ(refusal("time_s,current_A,voltage_V\n1,2,3\n"),
            "x.csv: line 1: must have one kind of input only (current_A, current1_A.., voltage_V, torque1_Nm..)");
}

// A simulation of one does not end. In the unit of the column.
TEST(CommandedInput, RefusesALevelBeyondAnyHardware) {
  EXPECT_EQ(refusal("time_s,current_A\n0,1e6\n0.1,-1e305\n"),
            "x.csv: line 3: column current_A: must be from -1000000 to 1000000; got -1e+305");
  EXPECT_EQ(refusal("time_s,torque1_Nmm,torque2_Nmm\n0,1e6,2e6\n"),
            "x.csv: line 2: column torque2_Nmm: must be from -1000000 to 1000000; got 2000000");
}

// They would be held as a whole, in some half a kilobyte each.
TEST(CommandedInput, RefusesMoreSamplesThanASimulationHolds) {
  std::string text = "time_s,current_A\n";
  for (int i = 0; i <= 1'000'000; ++i) text += std::to_string(i) + ",1\n";
  EXPECT_EQ(parse_commanded_input(text, "x.csv").times.size(), 1'000'001u);
  EXPECT_EQ(refusal(text + "1000001,1\n"),
            "x.csv: line 1000002: column time_s: must be the last: there may be 1000000 intervals, and the file has "
            "1000001; keep one row of 2, or cut the file; got 1000000");
}

TEST(CommandedInput, RefusesATimeThatGoesBackOrStandsStill) {
  EXPECT_EQ(refusal("time_s,current_A\n0.1,2\n0.3,2\n0.2,2\n"),
            "x.csv: line 4: column time_s: must exceed the value before it (0.3); the clock starts again here, so the "
            "file holds 2 records: make a file of each, with the line of names; got 0.2");
  EXPECT_EQ(
      refusal("time_s,current_A\n0.1,2\n0.1,2\n"),
      "x.csv: line 3: column time_s: must exceed the value before it (0.1); delete line 3, which repeats the time "
      "of the row above; got 0.1");
}

}  // namespace
}  // namespace coilwright::formats
