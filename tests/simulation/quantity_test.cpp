#include "coilwright/simulation/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/winding/wire_gauge.hpp"

namespace coilwright::simulation {
namespace {

// The default finger at 0.9 of the ampacity of its wire.
EvaluatedDesign prototype() {
  const actuator::Design design;
  return evaluate(design, {.current = 0.9 * winding::gauge(design.coil.wire_gauge).chassis_ampacity,
                           .duty = 0.4,
                           .period = 2.0,
                           .supply = {.voltage = 7.4}});
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
  design.magnet.grade = magnetics::find_magnet_grade("N42SH");  // so that there is a coercivity, and margin to it
  const EvaluatedDesign base = evaluate(design, prototype().point);
  for (const ResultQuantity& quantity : standard_quantities()) {
    const std::optional<double> value = quantity.value(base.view());
    ASSERT_TRUE(value.has_value()) << quantity.name;
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
  // Two angles, seven numbers of the step, frequency and damping of a mode, two forces and the current.
  EXPECT_EQ(lumped, 2 + 7 + 2 + 2 + 1);
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
