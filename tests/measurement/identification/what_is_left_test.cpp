#include "measurement/identification/what_is_left.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace coilwright::measurement::identification {
namespace {

double probability(const std::vector<WhatIsLeft>& grid, bool (*of)(const WhatIsLeft&)) {
  double out = 0.0;
  for (const WhatIsLeft& each : grid)
    if (of(each)) out += std::exp(each.log_prior);
  return out;
}

// That something is missing, between the ends of the grid, as the integral of the half-Cauchy density gives it.
double between_the_ends(double least, double largest) {
  return (std::atan(largest) - std::atan(least)) / std::numbers::pi;
}

TEST(WhatIsLeft, NothingIsMissingWithAHalf) {
  const auto grid = all_that_may_be_left({.longest = 1000, .largest_deviation = 40.0});
  EXPECT_NEAR(probability(grid, [](const WhatIsLeft& each) { return each.missing.deviation == 0.0; }), 0.5, 1e-12);
  EXPECT_NEAR(probability(grid, [](const WhatIsLeft& each) { return each.missing.deviation > 0.0; }),
              between_the_ends(0.016, 40.0), 0.01);
}

TEST(WhatIsLeft, NoiseOfUnknownColourIsWhiteOrNotAndAsLargeAsStated) {
  const auto grid = all_that_may_be_left({.longest = 1000, .largest_deviation = 40.0, .longest_colour = HUGE_VAL});
  const auto coloured = [](const WhatIsLeft& each) {
    return each.missing.deviation == 0.0 && each.colour.deviation > 0.0;
  };
  EXPECT_NEAR(probability(grid, coloured), 0.25, 1e-12);
  EXPECT_NEAR(probability(grid, [](const WhatIsLeft& each) { return each.colour.deviation == 0.0; }), 0.25, 1e-12);
  for (const WhatIsLeft& each : grid)
    if (coloured(each)) {
      EXPECT_NEAR(each.colour.deviation * each.colour.deviation + each.colour.white, 1.0, 1e-12);
    }
}

TEST(WhatIsLeft, LengthsReachFromTwoSamplesToAThirdOfTheLongestSeries) {
  for (const WhatIsLeft& each : all_that_may_be_left({.longest = 600, .largest_deviation = 2.0}))
    if (each.missing.deviation > 0.0) {
      EXPECT_GT(each.missing.length, 2.0);
      EXPECT_LT(each.missing.length, 200.0);
    }
}

TEST(WhatIsLeft, WhatNoTorqueCanMakeIsNoiseOfAnotherColour) {
  for (const WhatIsLeft& each :
       all_that_may_be_left({.shortest = 6.0, .longest = 600, .largest_deviation = 2.0, .longest_colour = 6.0}))
    if (each.missing.deviation > 0.0) {
      EXPECT_GT(each.missing.length, 6.0);
    } else {
      EXPECT_LT(each.colour.length, 6.0);
    }
}

TEST(WhatIsLeft, ColourThatAnotherRecordToldIsNoLongerThanItsSeriesHasIt) {
  const WhatIsLeft colour{.colour = {.deviation = 0.5, .length = 10.0}};
  EXPECT_EQ(colour.in({.longest_colour = 6.0}).deviation, 0.0);
  EXPECT_EQ(colour.in({.longest_colour = 10.0}).deviation, 0.5);
}

TEST(WhatIsLeft, AShortSeriesHasOneLength) {
  const auto grid = all_that_may_be_left({.longest = 3, .largest_deviation = 0.03});
  ASSERT_EQ(grid.size(), 2U);
  EXPECT_NEAR(grid[1].missing.length, 2.0 * std::numbers::sqrt2, 1e-12);
}

}  // namespace
}  // namespace coilwright::measurement::identification
