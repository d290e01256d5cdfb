#include "coilwright/drive/settings.hpp"

#include <gtest/gtest.h>

#include "drive/prototype_coils.hpp"
#include "error_text.hpp"

namespace coilwright::drive {
namespace {

const HBridge bridge{.supply_voltage = 24.0};

TEST(Settings, OfAnIdealDriverAreOhmsLaw) {
  // With the same resistance on and off the circuit is linear: mean = duty V / (R + r) at any frequency.
  const HBridge ideal{.supply_voltage = 24.0, .high_resistance = 0.2, .low_resistance = 0.2, .dead_time = 0.0};
  for (const double frequency : {3.0, 490.0, 2e4}) {
    const Setting duty = duty_for_mean(coils, driver_of(ideal), frequency, 1.4);
    ASSERT_TRUE(duty.value.has_value());
    EXPECT_NEAR(*duty.value, 1.4 * 8.0 / 24.0, 1e-11) << frequency;  // the bisection's
    const auto at = [&](double voltage) {
      HBridge other = ideal;
      other.supply_voltage = voltage;
      return driver_of(other);
    };
    const Setting voltage = voltage_for_mean(coils, at, {.frequency = frequency, .duty = 0.7}, 1.4, 60.0);
    ASSERT_TRUE(voltage.value.has_value());
    EXPECT_NEAR(*voltage.value, 1.4 * 8.0 / 0.7, 1e-9) << frequency;
  }
}

TEST(Settings, GiveTheMeanThatWasWanted) {
  for (const Decay decay : {Decay::slow, Decay::fast}) {
    HBridge real = bridge;
    real.decay = decay;
    for (const double mean : {0.07, 0.6, 1.3, 2.4}) {
      const Setting duty = duty_for_mean(coils, driver_of(real), 490.0, mean);
      ASSERT_TRUE(duty.value.has_value()) << mean;
      EXPECT_NEAR(duty.current.mean, mean, 1e-9) << mean;
      EXPECT_DOUBLE_EQ(duty.current.mean,
                       steady_current(coils, driver_of(real), {.frequency = 490.0, .duty = *duty.value}).mean);
    }
  }
}

TEST(Settings, SayWhatCanBeHadWhereTheMeanIsOutOfReach) {
  const Setting weak = duty_for_mean(coils, driver_of(bridge), 490.0, 3.0);
  EXPECT_FALSE(weak.value.has_value());
  EXPECT_NEAR(weak.current.mean, 24.0 / (7.6 + 0.565), 1e-12);  // Ohm's law, full on
  HBridge limited = bridge;
  limited.trip = 1.2;
  const Setting chopped = duty_for_mean(coils, driver_of(limited), 490.0, 1.25);
  EXPECT_FALSE(chopped.value.has_value());
  EXPECT_TRUE(chopped.current.is_limited);
  EXPECT_LT(chopped.current.mean, 1.2);
}

TEST(Settings, RejectAMeanThatIsNone) {
  EXPECT_EQ(error_text([] { (void)duty_for_mean(coils, driver_of(bridge), 490.0, -1.0); }),
            "mean: must be finite and > 0; got -1");
  EXPECT_EQ(error_text([] { (void)duty_for_mean(coils, driver_of(bridge), 0.0, 1.0); }),
            "frequency: must be finite and > 0; got 0");
}

}  // namespace
}  // namespace coilwright::drive
