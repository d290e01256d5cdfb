#include "coilwright/simulation/model_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "coilwright/actuator/assemble.hpp"
#include "error_text.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;
using actuator::Model;
using ::testing::ElementsAre;

// The prototype without what is known of its coils' wire.
Model without_resistance() {
  actuator::ModelSpec spec = finger(Configuration::B).model.nominal_spec();
  spec.coil_resistance.reset();
  return Model(std::move(spec));
}

TEST(ModelInput, GivesACommonCurrentToEveryCoil) {
  const Model model = finger(Configuration::B).model;
  const ModelInput input = model_input(model, {.times = {0.1, 0.4}, .rows = {{1.1}, {-0.7}}});
  EXPECT_THAT(input.times, ElementsAre(0.1, 0.4));
  ASSERT_EQ(input.currents.size(), 2U);
  EXPECT_THAT(input.currents[0], ElementsAre(1.1, 1.1));
  EXPECT_THAT(input.currents[1], ElementsAre(-0.7, -0.7));
  EXPECT_TRUE(input.joint_torques.empty());
}

TEST(ModelInput, GivesEachCoilItsOwnCurrent) {
  const Model model = finger(Configuration::B).model;
  const ModelInput input = model_input(model, {.addressing = Addressing::each, .times = {0.0}, .rows = {{1.1, 0.3}}});
  EXPECT_THAT(input.currents.front(), ElementsAre(1.1, 0.3));
}

// A prototype's coil has about 4 ohm: the current is the voltage over the resistance of one coil.
TEST(ModelInput, DividesAVoltageByTheResistanceOfACoil) {
  const actuator::Assembly assembly = finger(Configuration::B);
  ASSERT_TRUE(assembly.model.coil_resistance());
  EXPECT_EQ(*assembly.model.coil_resistance(), assembly.coil.resistance);
  const CommandedInput common{.drive = Drive::voltage, .times = {0.0}, .rows = {{4.2}}};
  EXPECT_THAT(model_input(assembly.model, common).currents.front(),
              ElementsAre(4.2 / assembly.coil.resistance, 4.2 / assembly.coil.resistance));
  const CommandedInput each{
      .drive = Drive::voltage, .addressing = Addressing::each, .times = {0.0}, .rows = {{4.2, -1.3}}};
  EXPECT_THAT(model_input(assembly.model, each).currents.front(),
              ElementsAre(4.2 / assembly.coil.resistance, -1.3 / assembly.coil.resistance));
}

TEST(ModelInput, LeavesTheCoilsOffUnderATorque) {
  const Model model = finger(Configuration::B).model;
  const ModelInput input = model_input(model, {.drive = Drive::torque, .times = {0.0}, .rows = {{1e-3, -2e-3}}});
  EXPECT_THAT(input.currents.front(), ElementsAre(0.0, 0.0));
  EXPECT_THAT(input.joint_torques.front(), ElementsAre(1e-3, -2e-3));
}

TEST(ModelInput, SaysWhyAModelCannotBeDrivenSo) {
  const auto refusal = [](const Model& model, const CommandedInput& command) {
    return error_text([&] { (void)model_input(model, command); });
  };
  const Model model = finger(Configuration::B).model;
  EXPECT_EQ(refusal(model, {.addressing = Addressing::each, .times = {0.0}, .rows = {{1.0, 2.0, 3.0}}}),
            "needs a current for each of the 2 coils; got 3");
  EXPECT_EQ(refusal(model, {.drive = Drive::voltage, .addressing = Addressing::each, .times = {0.0}, .rows = {{1.0}}}),
            "needs a voltage for each of the 2 coils; got 1");
  EXPECT_EQ(refusal(model, {.times = {0.0}, .rows = {{1.0, 2.0}}}), "needs 1 value for all coils; got 2");
  EXPECT_EQ(refusal(model, {.drive = Drive::torque, .times = {0.0}, .rows = {{1.0}}}),
            "needs a torque for each of the 2 joints; got 1");
  EXPECT_EQ(refusal(without_resistance(), {.drive = Drive::voltage, .times = {0.0}, .rows = {{4.0}}}),
            "has a voltage, and a lumped model has no coil resistance");
  const mechanics::Link link{.length = 0.1, .com_along = 0.06, .com_offset = 0.0, .mass = 0.2, .inertia = 0.0};
  const Model bare({.chain = mechanics::PlanarChain({&link, 1}, 9.81),
                    .hinges = {actuator::Hinge{}},
                    .magnetics = {},
                    .coils = 0,
                    .tip = {}});
  EXPECT_EQ(refusal(bare, {.times = {0.0}, .rows = {{1.0}}}), "drives coils, and the model has none");
}

TEST(ModelInput, HasPartsOfItsSamples) {
  const Model model = finger(Configuration::B).model;
  const ModelInput currents = model_input(model, {.times = {0.0, 0.1, 0.3}, .rows = {{1.0}, {2.0}, {3.0}}}).part(1, 3);
  EXPECT_THAT(currents.times, ElementsAre(0.1, 0.3));
  EXPECT_THAT(currents.currents.front(), ElementsAre(2.0, 2.0));
  EXPECT_TRUE(currents.joint_torques.empty());
  const CommandedInput pushed{.drive = Drive::torque, .times = {0.0, 0.1}, .rows = {{1.0, 2.0}, {3.0, 4.0}}};
  EXPECT_THAT(model_input(model, pushed).part(0, 1).joint_torques, ElementsAre(ElementsAre(1.0, 2.0)));
}

}  // namespace
}  // namespace coilwright::simulation
