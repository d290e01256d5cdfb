#include "coilwright/formats/simulation/input_signal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "temporary_folder.hpp"
#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

using ::testing::ElementsAre;

std::string refusal(std::string_view text) {
  return text::testing::error_of([&] { (void)parse_input_signal(text, "x.csv"); });
}

TEST(InputSignal, CommandsAllCoilsByOneColumn) {
  const coilwright::testing::TemporaryFolder folder;
  const InputSignal signal = read_input_signal(folder.file("x.csv", "time_s,current_A\n0.1,1.4\n0.35,-0.7\n"));
  EXPECT_EQ(signal.kind, InputKind::current);
  EXPECT_EQ(signal.addressing, InputAddressing::common);
  EXPECT_THAT(signal.times, ElementsAre(0.1, 0.35));
  EXPECT_THAT(signal.values, ElementsAre(ElementsAre(1.4, -0.7)));
}

TEST(InputSignal, CommandsEachJointByAColumnOfItsOwn) {
  const InputSignal signal = parse_input_signal("torque2_Nmm,time_s,torque1_Nm\n9.9,0.1,2.5\n4.35,0.2,3.5\n", "x.csv");
  EXPECT_EQ(signal.kind, InputKind::torque);
  EXPECT_EQ(signal.addressing, InputAddressing::each);
  EXPECT_THAT(signal.values, ElementsAre(ElementsAre(2.5, 3.5), ElementsAre(0.0099, 0.00435)));
}

TEST(InputSignal, LeavesMeasuredColumnsAside) {
  const InputSignal signal =
      parse_input_signal("time_s,voltage_V,theta1_rad,omega1_deg_s,bending_angle_deg\n0.5,2.5,3,4,5\n", "x.csv");
  EXPECT_EQ(signal.kind, InputKind::voltage);
  EXPECT_THAT(signal.values, ElementsAre(ElementsAre(2.5)));
}

TEST(InputSignal, RefusesAMissingOrMisspeltInput) {
  EXPECT_EQ(refusal("time_s,theta1_deg\n1,2\n"),
            "x.csv: line 1: must have an input column: current_A, current1_A.., voltage_V or torque1_Nm..");
  EXPECT_EQ(refusal("time_s,curent_A\n1,2\n"),
            "x.csv: line 1: column curent_A: unknown column; did you mean \"current_A\"?");
  EXPECT_EQ(refusal("time_s,current_mA\n1,2\n"),
            "x.csv: line 1: column current_mA: unknown unit; did you mean \"current_A\"?");
  EXPECT_EQ(refusal("current_A\n2\n"), "x.csv: line 1: column time_s: is missing");
  EXPECT_EQ(refusal("time_s,torque_Nm\n1,2\n"),
            "x.csv: line 1: column torque_Nm: unknown column; did you mean \"torque1_Nm\"?");
}

TEST(InputSignal, RefusesTwoKindsOfInput) {
  EXPECT_EQ(refusal("time_s,current_A,voltage_V\n1,2,3\n"),
            "x.csv: line 1: must have one kind of input only (current_A, current1_A.., voltage_V, torque1_Nm..)");
}

TEST(InputSignal, RefusesATimeThatGoesBackOrStandsStill) {
  EXPECT_EQ(refusal("time_s,current_A\n0.1,2\n0.3,2\n0.2,2\n"),
            "x.csv: line 4: column time_s: must exceed the value before it (0.3); got 0.2");
  EXPECT_EQ(refusal("time_s,current_A\n0.1,2\n0.1,2\n"),
            "x.csv: line 3: column time_s: must exceed the value before it (0.1); got 0.1");
}

}  // namespace
}  // namespace coilwright::formats
