#include "coilwright/measurement/replay/declare.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "error_text.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::ModelSpec;

// A pendulum of two links whose joints differ.
ModelSpec pendulum() {
  const std::vector<mechanics::Link> links(2, {.length = 0.02, .com_along = 0.01, .mass = 0.015});
  return {.chain = mechanics::PlanarChain(links),
          .hinges = {{.stiffness = 0.012, .damping = 1.1e-4}, {.stiffness = 0.016, .damping = 1.3e-4}},
          .magnetics = {},
          .coils = 0,
          .tip = {.link = 1, .along = 0.02}};
}

TEST(Declare, LetsStiffnessAndDampingOfADesignMove) {
  const actuator::Design design = actuator::paper_finger();
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const DeclaredModel declared = declare(design);
  ASSERT_EQ(declared.calibration.size(), 2u);
  EXPECT_EQ(declared.calibration[0].key, "joint_stiffness_Nmm_rad");
  EXPECT_EQ(declared.calibration[1].key, "joint_damping_Nmms_rad");
  EXPECT_EQ(declared.calibration[0].declared, assembly.model.hinges().front().stiffness);
  EXPECT_EQ(declared.calibration[1].declared, assembly.model.hinges().front().damping);
  EXPECT_TRUE(declared.heat.has_value());
  const ModelSpec moved = declared.build(std::vector{0.02, 3e-4});
  for (const actuator::Hinge& hinge : moved.hinges) {
    EXPECT_EQ(hinge.stiffness, 0.02);
    EXPECT_EQ(hinge.damping, 3e-4);
  }
}

TEST(Declare, KeepsTheRatioOfJointsThatDiffer) {
  const DeclaredModel declared = declare(pendulum(), {JointNumber::stiffness});
  ASSERT_EQ(declared.calibration.size(), 1u);
  EXPECT_DOUBLE_EQ(declared.calibration[0].declared, 0.014);
  const ModelSpec moved = declared.build(std::vector{0.028});
  EXPECT_DOUBLE_EQ(moved.hinges[0].stiffness, 0.024);
  EXPECT_DOUBLE_EQ(moved.hinges[1].stiffness, 0.032);
  EXPECT_EQ(moved.hinges[1].damping, 1.3e-4);
  EXPECT_FALSE(declared.heat.has_value());
}

TEST(Declare, LeavesOutANumberThatIsZeroAtEveryJoint) {
  ModelSpec spec = pendulum();
  for (actuator::Hinge& hinge : spec.hinges) hinge.damping = 0.0;
  const DeclaredModel declared = declare(spec);
  ASSERT_EQ(declared.calibration.size(), 1u);
  EXPECT_EQ(declared.calibration[0].key, "joint_stiffness_Nmm_rad");
  EXPECT_EQ(declared.build(std::vector{0.014}).hinges[0].damping, 0.0);
}

TEST(Declare, NamesTheNumbersOfDeclaredEffectsThatStay) {
  ModelSpec spec = pendulum();
  spec.effects = {{.kind = actuator::standard_effects().find("dry_friction"), .values = {1e-4}}};
  EXPECT_EQ(declare(spec).uncalibrated_effect_numbers, std::vector<std::string>{"torque_Nmm of dry_friction"});
}

TEST(Declare, RefusesWhatItCannotFit) {
  const std::vector twice = {JointNumber::damping, JointNumber::stiffness, JointNumber::damping};
  EXPECT_EQ(error_text([&] { (void)declare(pendulum(), twice); }), "calibrated: must not name a number twice");
  EXPECT_EQ(error_text([] { (void)declare(pendulum()).build(std::vector{0.014}); }),
            "calibration must have 2 values; got 1");
}

}  // namespace
}  // namespace coilwright::measurement::replay
