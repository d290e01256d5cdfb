#include "coilwright/measurement/replay/tolerance_plan.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace coilwright::measurement::replay {
namespace {

using ::testing::ElementsAre;

const std::vector<std::string> calibrated = {"joint_damping"};

// A rod of 0.5 kg on 0.2 m, without coils and faces.
actuator::LumpedModel rod() {
  return {.links = {{.length = 0.2, .com_along = 0.2, .com_offset = 0.0, .mass = 0.5, .inertia = 0.0}},
          .hinges = {{.stiffness = 0.1, .damping = 0.005}}};
}

std::vector<std::string> names(const TolerancePlan& plan) {
  std::vector<std::string> out;
  for (const PlannedNumber& number : plan.numbers) out.push_back(number.name);
  return out;
}

TEST(TolerancePlan, MovesWhatAnExperimenterDoubtsWhereNothingIsSaid) {
  const TolerancePlan plan = tolerance_plan(calibrated, {}, rod());
  EXPECT_THAT(names(plan), ElementsAre("joint_damping", "joint_stiffness", "/links/0/mass_kg", "/links/0/com_along_m"));
  EXPECT_EQ(plan.numbers[0].by, MovedBy::calibrate);
  EXPECT_EQ(plan.numbers[1].by, MovedBy::defaults);
  EXPECT_EQ(plan.numbers[1].share, 0.10);
  EXPECT_EQ(plan.numbers[2].share, 0.03);
  EXPECT_EQ(plan.numbers[2].effect, "added_mass");
  EXPECT_FALSE(plan.force_curve);
}

TEST(TolerancePlan, MovesWhatIsNamedAlone) {
  const TolerancePlan plan =
      tolerance_plan(calibrated, {.others_exact = true, .named = {{"/links/0/mass_kg", 0.01}}}, rod());
  EXPECT_THAT(names(plan), ElementsAre("joint_damping", "/links/0/mass_kg"));
  EXPECT_EQ(plan.numbers[1].by, MovedBy::tolerances);
  EXPECT_EQ(plan.numbers[1].deviation, 0.01);
  EXPECT_THAT(plan.held_exact, ElementsAre("all declared numbers that are not calibrated"));
}

// By a search through all others for each of them, a file with so many took 12 s to be refused.
TEST(TolerancePlan, TakesAHundredThousandNames) {
  std::vector<std::string> many;
  Tolerances said{.others_exact = true, .named = {}};
  for (int i = 0; i < 100'000; ++i) {
    many.push_back("/x/" + std::to_string(i));
    said.named.push_back({many.back(), 0.5});
    said.named.push_back({"/y/" + std::to_string(i), 0.25});
  }
  const TolerancePlan plan = tolerance_plan(many, said, rod());
  ASSERT_EQ(plan.numbers.size(), 200'000u);
  EXPECT_EQ(plan.numbers[99'999].name, "/x/99999");
  EXPECT_EQ(plan.numbers[99'999].by, MovedBy::calibrate);
  EXPECT_EQ(plan.numbers[99'999].deviation, 0.5);
  EXPECT_EQ(plan.numbers.back().name, "/y/99999");
  EXPECT_EQ(plan.numbers.back().deviation, 0.25);
}

TEST(TolerancePlan, NamesTheToleranceThatTheModelCannotHave) {
  try {
    (void)tolerance_plan(calibrated, {.named = {{"face_closing_deg", 1.0}}}, rod());
    FAIL() << "faces that are not there";
  } catch (const ToleranceFault& fault) {
    EXPECT_EQ(fault.name(), "face_closing_deg");
    EXPECT_STREQ(fault.what(), "must not be there: the actuator has no faces that touch");
    EXPECT_EQ(fault.value(), "");
  }
}

// A mass of 0.5 kg known to 0.6 kg is not declared.
TEST(TolerancePlan, NamesTheToleranceThatExceedsItsNumber) {
  const TolerancePlan plan = tolerance_plan({}, {.others_exact = true, .named = {{"/links/0/mass_kg", 0.6}}}, rod());
  CalibratableNumber<LumpedTarget> mass;
  mass.parameter = {.key = "/links/0/mass_kg", .declared = 0.5, .lower = 0.0, .upper = 10.0, .scale = 0.5};
  const std::vector<CalibratableNumber<LumpedTarget>> in_file(1, mass);
  try {
    (void)with_tolerances(in_file, plan);
    FAIL() << "a tolerance above the number";
  } catch (const ToleranceFault& fault) {
    EXPECT_EQ(fault.name(), "/links/0/mass_kg");
    EXPECT_EQ(fault.value(), "0.6");
  }
}

}  // namespace
}  // namespace coilwright::measurement::replay
