#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coilwright/measurement/planning/synthetic_data.hpp"

namespace coilwright::measurement::planning {
namespace {

TEST(InputShape, AStepAndAHoldChangeAtTheirTimes) {
  const InputShape step = StepShape{.before = 0.2, .after = 1.4, .at = 0.1};
  EXPECT_EQ(level_at(step, 0.0999, 2.0), 0.2);
  EXPECT_EQ(level_at(step, 0.1, 2.0), 1.4);
  // The 50th of 500 samples a second is at 0.1 s, though 50 * 0.002 need not be.
  EXPECT_EQ(level_at(step, 50 / 500.0, 2.0), 1.4);
  const InputShape hold = HoldShape{.level = 1.0, .from = 0.5, .until = 1.5};
  EXPECT_EQ(level_at(hold, 0.4, 2.0), 0.0);
  EXPECT_EQ(level_at(hold, 0.5, 2.0), 1.0);
  EXPECT_EQ(level_at(hold, 1.5, 2.0), 0.0);
}

TEST(InputShape, ASinePeaksAfterAQuarterPeriod) {
  const InputShape sine = SineShape{.amplitude = 0.7, .offset = 0.6, .frequency = 2.0};
  EXPECT_EQ(level_at(sine, 0.0, 1.0), 0.6);
  EXPECT_NEAR(level_at(sine, 0.125, 1.0), 1.3, 1e-15);
  EXPECT_NEAR(level_at(sine, 0.375, 1.0), -0.1, 1e-15);
}

TEST(InputShape, AChirpChangesItsFrequencyLinearly) {
  const ChirpShape chirp{.amplitude = 1.0, .offset = 0.0, .from = 1.0, .to = 5.0};
  constexpr double duration = 4.0;
  // Its slope over its quadrature is the angular frequency: differences of the phase, a second route to the frequency.
  constexpr double h = 1e-5;
  for (const double time : {0.5, 2.0, 3.5}) {
    const auto at = [&](double t) { return level_at(chirp, t, duration); };
    const double frequency = 1.0 + 4.0 * time / duration;
    const double slope = (at(time + h) - at(time - h)) / (2 * h);
    const double expected = 2 * std::numbers::pi * frequency;
    EXPECT_NEAR(slope * slope + expected * expected * at(time) * at(time), expected * expected, 1e-4 * expected)
        << time;
  }
}

TEST(InputShape, PulsesAreHighForTheirShareOfEveryPeriod) {
  const InputShape pulses = PulseShape{.low = 0.1, .high = 1.2, .period = 0.1, .duty = 0.3};
  int high = 0;
  for (int i = 0; i < 1000; ++i) high += level_at(pulses, i / 1000.0, 1.0) == 1.2 ? 1 : 0;
  EXPECT_EQ(high, 300);
  EXPECT_EQ(level_at(pulses, 3 * 0.1, 1.0), 1.2);  // 3 * 0.1 is above 0.3
  EXPECT_EQ(level_at(pulses, 0.7, 1.0), 1.2);      // and 0.7 / 0.1 below 7
  EXPECT_EQ(level_at(pulses, 0.99, 1.0), 0.1);
}

}  // namespace
}  // namespace coilwright::measurement::planning
