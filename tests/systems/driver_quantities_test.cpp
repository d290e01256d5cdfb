#include "coilwright/systems/driver_quantities.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"

namespace coilwright::systems {
namespace {

simulation::QuantityTable table_of(const DriverTask& task) {
  return simulation::QuantityTable(driver_quantities([task](const simulation::Settings&) { return task; }));
}

// The paper's bridge, and the switches of its data sheet.
DriverTask bridge() {
  return {.voltage = 24.0, .switch_resistance = 0.565};
}

class DriverQuantities : public ::testing::Test {
 protected:
  [[nodiscard]] double value(const DriverTask& task, const char* name) const {
    const simulation::QuantityTable table = table_of(task);
    return table.at(name).value(design.view()).value();
  }
  simulation::EvaluatedDesign design = simulation::evaluate(validation::paper_finger(), {.current = 1.0, .duty = 0.6});
};

// By the same circuits, but through all that `drive` knows.
TEST_F(DriverQuantities, AreThoseOfTheDrivenActuator) {
  const DriverTask task = bridge();
  const DrivenActuator driven =
      drive_actuator(design.design, design.assembly, {.driver = drive::HBridge{.supply_voltage = 24.0}, .mean = 1.0});
  EXPECT_NEAR(value(task, "driver_peak_A"), driven.driver.peak, 1e-9);
  EXPECT_NEAR(value(task, "driver_peak_over_limit"), driven.driver.peak / 3.6, 1e-9);
  EXPECT_NEAR(value(task, "driver_ripple_heat_pct"), 100.0 * (driven.driver.powers.coils / driven.heat_by_mean - 1.0),
              1e-6);
  const double load = simulation::standard_quantities().at("thermal_load").value(design.view()).value();
  EXPECT_NEAR(value(task, "driver_thermal_load"), load * driven.coil.rms / driven.coil.mean, 1e-9);
}

// Far above R/L there is no ripple: the duty is that of resistances alone, on coils as warm as they are.
TEST_F(DriverQuantities, HaveNoRippleAtHighFrequencies) {
  DriverTask task = bridge();
  task.frequency = 1e6;
  EXPECT_LT(value(task, "driver_ripple_heat_pct"), 1e-3);
  const double warm = design.performance.free.heat.electrics.resistance.value();
  // The bridge's dead time of 0.22 us is taken off every pulse: 0.22 of a period at 1 MHz. While off, two low switches
  // are 0.516 ohm against 0.565 while on, and for the dead times 0.8 V of two diodes drive against the current.
  const double most = value(task, "driver_most_current_A");
  EXPECT_NEAR(most, 24.0 / (0.565 + 0.5 * warm) / 2.0, 1e-2 * most);
  EXPECT_GT(value(task, "driver_duty"), 1.0 / most);
}

TEST_F(DriverQuantities, SayWhatTheDriverCannotGive) {
  DriverTask task{.kind = DriverTask::Kind::cell, .voltage = 3.0, .resistance = 1.0, .switch_resistance = 0.05};
  const simulation::QuantityTable table = table_of(task);
  const simulation::ResultQuantity& duty = table.at("driver_duty");
  EXPECT_FALSE(duty.value(design.view()));
  const simulation::NoValue why = duty.why_absent(design.view());
  EXPECT_EQ(why.reason,
            "the driver cannot give the current: raise driver.voltage_V or lower current_A; got 0.456 A in a coil at "
            "most, warm, of 1 A");
  EXPECT_NEAR(why.infeasibility, 1.0 / 0.456 - 1.0, 5e-3);
  EXPECT_FALSE(table.at("driver_most_current_A").value(design.view()));
}

// No voltage holds a current for good whose coils warm without end.
TEST_F(DriverQuantities, SayThatTheCoilsRunAway) {
  const double beyond = 1.2 * design.performance.free.heat.runaway_current;
  design = simulation::evaluate(validation::paper_finger(), {.current = beyond});
  const simulation::QuantityTable table = table_of(bridge());
  const simulation::ResultQuantity& duty = table.at("driver_duty");
  EXPECT_FALSE(duty.value(design.view()));
  const simulation::NoValue why = duty.why_absent(design.view());
  EXPECT_EQ(why.reason.find("the driver cannot hold the current, at which the coils have no steady temperature"), 0u)
      << why.reason;
  EXPECT_GT(why.infeasibility, 1.0);
  // Unless the driver gives no such current even to cold coils.
  DriverTask weak = bridge();
  weak.voltage = 0.05;
  const simulation::QuantityTable of_weak = table_of(weak);
  EXPECT_THAT(of_weak.at("driver_duty").why_absent(design.view()).reason,
              ::testing::MatchesRegex("the driver cannot give the current: raise driver.voltage_V or lower current_A; "
                                      "got 0\\.0.* A in a coil at most, even at 20 degC, of .* A"));
}

// Coils in the grip are as warm as the grip makes them.
TEST_F(DriverQuantities, AreOfThePoseThatIsHeld) {
  const auto resistance = [](const simulation::Heat& heat) { return heat.electrics.resistance.value(); };
  const double free = value(bridge(), "driver_most_current_A");
  const double ratio = (2.0 * 0.565 + resistance(design.performance.free.heat)) /
                       (2.0 * 0.565 + resistance(design.performance.gripping.heat));
  design = simulation::evaluate(validation::paper_finger(),
                                {.current = 1.0, .duty = 0.6, .cases = actuator::HeldCases::gripping});
  // Less than free, and more than if all coils were as warm as the hottest.
  EXPECT_LT(value(bridge(), "driver_most_current_A"), 0.999 * free);
  EXPECT_GT(value(bridge(), "driver_most_current_A"), ratio * free);
}

// A design that is not driven needs nothing of its driver.
TEST_F(DriverQuantities, AreNothingWithoutCurrent) {
  design = simulation::evaluate(validation::paper_finger(), {.current = 0.0});
  EXPECT_EQ(value(bridge(), "driver_duty"), 0.0);
  EXPECT_EQ(value(bridge(), "driver_peak_A"), 0.0);
  EXPECT_EQ(value(bridge(), "driver_ripple_heat_pct"), 0.0);
  EXPECT_EQ(value(bridge(), "driver_thermal_load"), 0.0);
}

}  // namespace
}  // namespace coilwright::systems
