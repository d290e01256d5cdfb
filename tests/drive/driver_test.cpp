#include "coilwright/drive/driver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "error_text.hpp"

namespace coilwright::drive {
namespace {

TEST(Driver, OfABridgeFollowsTheSwitches) {
  const HBridge bridge{.supply_voltage = 23.0,
                       .supply_resistance = 0.11,
                       .high_resistance = 0.31,
                       .low_resistance = 0.24,
                       .diode_voltage = 0.77};
  const Driver slow = driver_of(bridge);
  EXPECT_DOUBLE_EQ(slow.on.resistance, 0.55);
  EXPECT_DOUBLE_EQ(slow.on.source, 23.0);
  EXPECT_DOUBLE_EQ(slow.off.resistance, 0.48);
  EXPECT_EQ(slow.off.source, 0.0);
  EXPECT_DOUBLE_EQ(slow.dead.diodes, 0.77);
  EXPECT_FALSE(slow.limit.has_value());
  HBridge opened = bridge;
  opened.decay = Decay::fast;
  const Driver fast = driver_of(opened);
  EXPECT_DOUBLE_EQ(fast.off.source, -23.0);
  EXPECT_DOUBLE_EQ(fast.off.diodes, 1.54);
  EXPECT_DOUBLE_EQ(fast.off.supply_resistance, 0.11);
  EXPECT_DOUBLE_EQ(fast.chop.resistance, 0.48);
}

TEST(Driver, OfACellLetsTheDiodeCarryTheCurrent) {
  const Driver cell = driver_of(CellSwitch{.emf = 3.9, .resistance = 0.2, .switch_resistance = 0.05});
  EXPECT_DOUBLE_EQ(cell.on.source, 3.9);
  EXPECT_DOUBLE_EQ(cell.on.supply_resistance, 0.2);
  EXPECT_EQ(cell.off.source, 0.0);
  EXPECT_DOUBLE_EQ(cell.off.diodes, 0.4);
}

TEST(Driver, RunsAsLongAsTheChargeLasts) {
  EXPECT_DOUBLE_EQ(run_time(540.0, 0.9), 600.0);
  EXPECT_TRUE(std::isinf(run_time(540.0, 0.0)));
}

TEST(Driver, RejectsWhatIsNone) {
  EXPECT_EQ(error_text([] { (void)driver_of(HBridge{.supply_voltage = -24.0}); }),
            "supply_voltage: must be finite and > 0; got -24");
  EXPECT_EQ(error_text([] { (void)driver_of(HBridge{.supply_voltage = 24.0, .trip = 0.0}); }),
            "trip: must be finite and > 0; got 0");
  EXPECT_EQ(error_text([] { (void)driver_of(HBridge{.supply_voltage = 24.0, .trip = 2.0, .limit_off_time = 0.0}); }),
            "limit_off_time: must be finite and > 0; got 0");
  EXPECT_EQ(error_text([] { (void)driver_of(CellSwitch{.emf = 4.0, .resistance = -0.1}); }),
            "resistance: must be finite and >= 0; got -0.1");
  EXPECT_EQ(error_text([] { (void)run_time(0.0, 1.0); }), "capacity: must be finite and > 0; got 0");
}

}  // namespace
}  // namespace coilwright::drive
