#include "coilwright/simulation/quantity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/pressed_joints.hpp"

namespace coilwright::simulation {
namespace {

// The default finger at 0.9 of the ampacity of its wire.
EvaluatedDesign prototype() {
  const actuator::Design design;
  return evaluate(
      design,
      {.current = 0.9 * wire_of(design.coil).chassis_ampacity, .duty = 0.4, .period = 2.0, .supply = {.voltage = 7.4}});
}

ResultQuantity specific_grasp_force() {
  return {.name = "grasp_force_per_mass_N_kg",
          .meaning = "grasp force divided by the mass of the actuator",
          .scale = 15.0,
          .value = [](const DesignView& d) { return d.performance.cold.grasp_force / d.performance.mass; }};
}

std::string refusal_of(const ResultQuantity& quantity) {
  try {
    (void)standard_quantities().with(quantity);
  } catch (const std::invalid_argument& refusal) {
    return refusal.what();
  }
  return "accepted";
}

TEST(Quantities, HaveNamesOfTheirOwnAndEverythingAReportNeeds) {
  std::set<std::string_view> names;
  for (const ResultQuantity& quantity : standard_quantities()) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
    EXPECT_GT(quantity.scale, 0.0) << quantity.name;
    EXPECT_EQ(standard_quantities().find(quantity.name), &quantity);
  }
  EXPECT_EQ(standard_quantities().find("weight_g"), nullptr);
  EXPECT_THROW((void)standard_quantities().at("weight_g"), std::invalid_argument);
}

TEST(Quantities, HaveTheAngleOfEachJointAndTheSmallest) {
  const EvaluatedDesign finger = prototype();
  const auto joint = [&](std::string_view name) {
    const auto row = std::ranges::find(joint_quantities(), name, &ResultQuantity::name);
    return row->value(finger.view());
  };
  const double first = joint("joint1_angle_deg").value();
  const double second = joint("joint2_angle_deg").value();
  EXPECT_NEAR(first + second, standard_quantities().at("steady_angle_deg").value(finger.view()).value(), 1e-12);
  EXPECT_EQ(standard_quantities().at("smallest_joint_angle_deg").value(finger.view()).value(), std::min(first, second));
  EXPECT_EQ(standard_quantities().at("smallest_rest_joint_angle_deg").value(finger.view()).value(),
            std::min(joint("rest_joint1_angle_deg").value(), joint("rest_joint2_angle_deg").value()));
  EXPECT_EQ(joint("joint3_angle_deg"), std::nullopt);
  for (const ResultQuantity& row : joint_quantities()) {
    EXPECT_EQ(standard_quantities().find(row.name), nullptr);
    EXPECT_FALSE(row.absence.empty());
  }
}

std::vector<PartLimit> limits_of_joints(const actuator::Design& design, double current) {
  const EvaluatedDesign evaluated = evaluate(design, {.current = current});
  std::vector<PartLimit> out = told(broken_part_limits(evaluated.view()), evaluated.view());
  std::erase_if(out, [](const PartLimit& limit) { return !limit.quantity.ends_with("joint_angle_deg"); });
  return out;
}

// In C two magnets of like polarity pull at each other through the coil between them, or push.
TEST(PartLimits, SayWhichJointsArePressedShut) {
  EXPECT_TRUE(limits_of_joints({}, 0.5).empty());
  const auto backwards = limits_of_joints({}, -1.0);
  ASSERT_EQ(backwards.size(), 1U);
  EXPECT_EQ(backwards[0].quantity, "smallest_joint_angle_deg");
  EXPECT_TRUE(
      backwards[0].consequence.starts_with("joints 1 and 2 are pressed shut at this current: they do not open; coil 1 "
                                           "and magnet 1 attract each other with "));
  EXPECT_TRUE(backwards[0].conditional);
  EXPECT_EQ(backwards[0].limit, 0.0);

  actuator::Design design;
  design.layout = actuator::layout_of(actuator::Configuration::C);
  const EvaluatedDesign at_rest = evaluate(design, {.current = 0.0});
  const std::vector<int> pressed = pressed_joints(at_rest.assembly.model, at_rest.performance.cold.rest_angles);
  ASSERT_FALSE(pressed.empty());
  const auto held = limits_of_joints(design, 0.0);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_NE(held[0].consequence.find("pressed shut at this current, as without it"), std::string::npos);
  EXPECT_LT(held[0].value.value(), 0.0);
  EXPECT_GT(held[0].value.value(), -0.5);
  // Its faces are the coil's and the magnet's where no silicone stands before them.
  design.choices.faces = actuator::ContactChoice::hard_parts;
  for (const PartLimit& limit : limits_of_joints(design, 0.0)) EXPECT_LT(limit.limit, -1.0);
}

TEST(PressedJoints, AreCalledByTheirNumbers) {
  using Joints = std::vector<int>;
  EXPECT_EQ(pressed_joints_text({}, {}), "");
  EXPECT_EQ(pressed_joints_text(Joints{1}, {}), "magnets or weight hold joint 2 shut without current");
  EXPECT_EQ(pressed_joints_text({}, Joints{0}), "joint 1 is pressed shut at this current: it does not open");
  EXPECT_EQ(pressed_joints_text(Joints{1, 2}, Joints{1, 2}),
            "joints 2 and 3 are pressed shut at this current, as without it: they do not bend");
  EXPECT_EQ(pressed_joints_text(Joints{1}, Joints{0, 2, 3}),
            "joints 1, 3 and 4 are pressed shut at this current, joint 2 without current");
}

TEST(Quantities, ThatMayHaveNoValueSayWhy) {
  actuator::Design hot;
  hot.surroundings.coil_limit = 20.0;  // below the ambient 25: no current at all may be held
  for (const double current : {0.0, 5.0}) {
    const EvaluatedDesign design = evaluate(hot, {.current = current});
    for (const ResultQuantity& quantity : standard_quantities())
      EXPECT_TRUE(quantity.value(design.view()) || !quantity.absence.empty()) << quantity.name;
  }
  const EvaluatedDesign still = evaluate(hot, {.current = 0.0});
  EXPECT_EQ(standard_quantities().at("rise_time_s").value(still.view()), std::nullopt);
  EXPECT_EQ(standard_quantities().at("thermal_load").value(still.view()), std::nullopt);
}

TEST(Quantities, ScaleIsWithinTenfoldOfThePrototype) {
  // Scales weigh limits of zero against each other; an order of magnitude is all they must get right.
  actuator::Design design = prototype().design;
  actuator::make_of_grade(design.magnet, "N42SH");  // so that there is a coercivity, and margin to it
  const EvaluatedDesign base = evaluate(design, prototype().point);
  for (const ResultQuantity& quantity : standard_quantities()) {
    const std::optional<double> value = quantity.value(base.view());
    ASSERT_TRUE(value.has_value()) << quantity.name;
    if (quantity.name == "irreversible_loss_pct") continue;  // that grade loses nothing
    EXPECT_LT(std::abs(std::log10(*value / quantity.scale)), 1.0) << quantity.name << " is " << *value;
  }
}

// What `evaluate` says of a lumped model is what it would say of a design that moves alike.
TEST(Quantities, OfALumpedModelAreThoseOfADesign) {
  const EvaluatedDesign base = prototype();
  int lumped = 0;
  for (const ResultQuantity& quantity : standard_quantities()) {
    if (!quantity.value_of_lumped) continue;
    ++lumped;
    EXPECT_EQ(quantity.value_of_lumped(base.performance.cold, base.point.current), quantity.value(base.view()))
        << quantity.name;
  }
  // Two angles, the smallest of each pose and the smallest change between them, seven numbers of the step, frequency
  // and damping of a mode, two forces and the current.
  EXPECT_EQ(lumped, 2 + 3 + 7 + 2 + 2 + 1);
}

TEST(QuantityTable, TakesAQuantityOfAUsersOwn) {
  const QuantityTable table = standard_quantities().with(specific_grasp_force());
  ASSERT_EQ(table.size(), standard_quantities().size() + 1);
  EXPECT_EQ(table[table.size() - 1].name, "grasp_force_per_mass_N_kg");
  EXPECT_EQ(standard_quantities().find("grasp_force_per_mass_N_kg"), nullptr);  // a value: the default stays as it is
  const EvaluatedDesign base = prototype();
  const double force = table.at("grasp_force_N").value(base.view()).value();
  const double mass = table.at("mass_g").value(base.view()).value();
  EXPECT_NEAR(table.at("grasp_force_per_mass_N_kg").value(base.view()).value(), force / mass * 1e3, 1e-12 * 1e3);
}

TEST(QuantityTable, SharesItsRowsWithItsCopies) {
  auto table = std::make_unique<QuantityTable>(standard_quantities().with(specific_grasp_force()));
  const QuantityTable copy = *table;
  const ResultQuantity* row = table->find("mass_g");
  table.reset();
  EXPECT_EQ(copy.find("mass_g"), row);
}

TEST(QuantityTable, RefusesARowThatNoReportCouldPrint) {
  EXPECT_EQ(refusal_of(specific_grasp_force()), "accepted");
  ResultQuantity row = specific_grasp_force();
  row.name = "mass_g";
  EXPECT_EQ(refusal_of(row), "quantity \"mass_g\": the name must not be taken by another quantity");
  row.name.clear();
  EXPECT_EQ(refusal_of(row), "quantity \"\": the name must not be empty");
  row = specific_grasp_force();
  row.meaning.clear();
  EXPECT_EQ(refusal_of(row), "quantity \"grasp_force_per_mass_N_kg\": the meaning must not be empty");
  row = specific_grasp_force();
  row.scale = 0.0;
  EXPECT_EQ(refusal_of(row), "quantity \"grasp_force_per_mass_N_kg\": the scale must be finite and > 0");
  row = specific_grasp_force();
  row.value = nullptr;
  EXPECT_EQ(refusal_of(row),
            "quantity \"grasp_force_per_mass_N_kg\": the function that gives the value must not be empty");
}

}  // namespace
}  // namespace coilwright::simulation
