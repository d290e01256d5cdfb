#include "coilwright/formats/actuator/actuator_argument.hpp"

#include <gtest/gtest.h>

#include "text/input_error_text.hpp"

namespace coilwright::formats {
namespace {

std::string argument_refusal(const std::string& argument) {
  return text::testing::error_of([&] { (void)parse_effect(argument); });
}

TEST(EffectArgument, GivesParametersInSiInTheOrderOfTheEffect) {
  const actuator::Effect friction = parse_effect("dry_friction:torque_Nmm=0.6");
  EXPECT_EQ(friction.kind, actuator::standard_effects().find("dry_friction"));
  ASSERT_EQ(friction.values.size(), 1u);
  EXPECT_DOUBLE_EQ(friction.values[0], 0.6e-3);
  const actuator::Effect creep = parse_effect("viscoelastic_creep:time_constant_s=0.5,stiffness_ratio=0.2");
  EXPECT_EQ(creep.values, (std::vector<double>{0.2, 0.5}));
}

TEST(EffectArgument, MayNameFurtherNumbersAllTogether) {
  const actuator::Effect friction =
      parse_effect("dry_friction:stribeck_rate_rad_s=0.8,torque_Nmm=0.6,stribeck_ratio=1.4");
  EXPECT_EQ(friction.kind, actuator::standard_effects().find("dry_friction")->with_further_numbers());
  EXPECT_EQ(friction.values, (std::vector<double>{0.6e-3, 1.4, 0.8}));
  EXPECT_EQ(
      argument_refusal("dry_friction:torque_Nmm=0.6,stribeck_ratio=1.4"),
      "dry_friction:torque_Nmm=0.6,stribeck_ratio=1.4: needs stribeck_rate_rad_s: joint rate at which most of the "
      "difference has gone");
}

TEST(EffectArgument, IsRefusedInALineThatNamesTheRule) {
  EXPECT_EQ(argument_refusal("dry_fricton:torque_Nmm=0.6"),
            R"(dry_fricton:torque_Nmm=0.6: "dry_fricton" is not an effect; did you mean "dry_friction"?)");
  EXPECT_EQ(argument_refusal(""), R"(: "" is not an effect)");
  EXPECT_EQ(
      argument_refusal("dry_friction:torque_Nm=0.6"),
      R"(dry_friction:torque_Nm=0.6: "torque_Nm" is not a parameter of dry_friction; did you mean "torque_Nmm"?)");
  EXPECT_EQ(argument_refusal("dry_friction"),
            "dry_friction: needs torque_Nmm: friction torque of a sliding joint, every joint");
  EXPECT_EQ(argument_refusal("dry_friction:torque_Nmm"),
            R"(dry_friction:torque_Nmm: must be a name and a value, as in "dry_friction:torque_Nmm=0.6")");
  EXPECT_EQ(argument_refusal("dry_friction:torque_Nmm=0.6,"),
            R"(dry_friction:torque_Nmm=0.6,: must be a name and a value, as in "dry_friction:torque_Nmm=0.6")");
  EXPECT_EQ(argument_refusal("dry_friction:torque_Nmm=0.6,torque_Nmm=0.7"),
            R"(dry_friction:torque_Nmm=0.6,torque_Nmm=0.7: "torque_Nmm" must not be there twice)");
  EXPECT_EQ(argument_refusal("dry_friction:torque_Nmm=nan"), "dry_friction:torque_Nmm=nan: must be a finite number");
  EXPECT_EQ(argument_refusal("dry_friction:torque_Nmm=1,5"),
            R"(dry_friction:torque_Nmm=1,5: must be a name and a value, as in "dry_friction:torque_Nmm=0.6")");
  EXPECT_EQ(argument_refusal("dry_friction:torque_Nmm=-1"),
            "dry_friction:torque_Nmm=-1: effect dry_friction: torque_Nmm must be >= 0; got -1");
}

}  // namespace
}  // namespace coilwright::formats
