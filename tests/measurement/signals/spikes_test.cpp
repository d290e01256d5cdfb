#include "measurement/signals/spikes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::signals {
namespace {

constexpr double sigma = 0.3;  // deg

// A swing of 30 deg at 2 Hz under 240 pictures a second.
std::vector<double> swing(std::uint64_t seed) {
  Normal normal(seed);
  std::vector<double> out(1200);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = 30.0 * std::sin(2.0 * std::numbers::pi * 2.0 * static_cast<double>(i) / 240.0) + sigma * normal();
  return out;
}

TEST(Spikes, AreInNoneOfAHundredRecordsOfWhiteNoise) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Normal normal(seed);
    std::vector<double> values(1000);
    for (double& value : values) value = normal();
    found += static_cast<int>(std::ranges::count(spikes(values), 1));
  }
  EXPECT_EQ(found, 0);
}

TEST(Spikes, OfFiveDegreesAreFoundAllAndNothingElse) {
  // The residual of a fit: the swing is gone.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Normal normal(seed);
    std::vector<double> values(1200);
    for (double& value : values) value = sigma * normal();
    std::set<std::size_t> places;
    while (places.size() < 24) places.insert(static_cast<std::size_t>(1200.0 * normal.uniform()));
    for (const std::size_t place : places) values[place] += place % 2 == 0 ? 5.0 : -5.0;
    const std::vector<char> found = spikes(values);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(found[i] != 0, places.contains(i)) << seed << ", " << i;
  }
}

TEST(Spikes, AreNotTheSwingItself) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<char> found = spikes(swing(seed));
    // The first and the last four have neighbours on one side only.
    EXPECT_EQ(std::count(found.begin() + 4, found.end() - 4, 1), 0) << seed;
  }
}

// What a wrong model leaves of a window grows towards its ends, by a factor of e in ten samples: that is no spike. A
// misread first or last picture is one all the same.
TEST(Spikes, AtTheEndsAreNoDrift) {
  Normal normal(7);
  std::vector<double> values(250);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = sigma * (normal() + 60.0 * std::exp((static_cast<double>(i) - 249.0) / 10.0) -
                         60.0 * std::exp(-static_cast<double>(i) / 10.0));
  EXPECT_EQ(std::ranges::count(spikes(values, sigma), 1), 0);
  values.front() += 60.0 * sigma;
  values.back() -= 60.0 * sigma;
  const std::vector<char> found = spikes(values, sigma);
  EXPECT_EQ(std::ranges::count(found, 1), 2);
  EXPECT_EQ(found.front(), 1);
  EXPECT_EQ(found.back(), 1);
}

TEST(Spikes, LastThreeSamplesAtMost) {
  std::vector<double> values(200, 0.0);
  Normal normal(1);
  for (double& value : values) value = 0.1 * normal();
  std::vector<double> event = values;
  for (std::size_t i = 50; i < 53; ++i) values[i] += 5.0;
  for (std::size_t i = 50; i < 54; ++i) event[i] += 5.0;
  EXPECT_EQ(std::ranges::count(spikes(values), 1), 3);
  const std::vector<char> found = spikes(event);
  EXPECT_EQ(std::count(found.begin() + 50, found.begin() + 54, 1), 0);
}

TEST(Spikes, AreNotWhatIsSmallerThanTheLeast) {
  std::vector<double> rounded(100, 1.0);  // more than half of the differences are zero
  rounded[40] = 1.02;
  EXPECT_EQ(spikes(rounded, 0.003)[40], 1);
  EXPECT_EQ(spikes(rounded, 0.01)[40], 0);
}

TEST(Spikes, AreBridgedByAStraightLine) {
  std::vector<double> ramp(100);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = 0.5 * static_cast<double>(i);
  std::vector<double> spiky = ramp;
  spiky[30] += 40.0;
  spiky[31] -= 40.0;
  spiky[70] += 40.0;
  const std::vector<double> bridged = without_spikes(spiky);
  for (std::size_t i = 0; i < ramp.size(); ++i) EXPECT_NEAR(bridged[i], ramp[i], 1e-12) << i;
}

TEST(FarValues, AreUpToThreeInARowAndAFewInAll) {
  std::vector<double> values(40);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 2 == 0 ? 0.67449 : -0.67449;  // deviation 1
  values[5] = 4.1;
  values[20] = -9.0;
  values[30] = 3.9;
  std::vector<char> expected(values.size(), 0);
  expected[5] = expected[20] = 1;
  EXPECT_EQ(far_values(values, 0.1), expected);
  expected[5] = 0;
  EXPECT_EQ(far_values(values, 1.5), expected);  // a least deviation

  std::vector<double> event = values;
  for (std::size_t i = 10; i < 14; ++i) event[i] = 9.0;
  expected[5] = 1;
  EXPECT_EQ(far_values(event, 0.1), expected);
  for (const std::size_t i : {10u, 24u, 34u}) values[i] = 9.0;
  EXPECT_EQ(std::ranges::count(far_values(values, 0.1), 1), 0);  // five of forty
  EXPECT_EQ(std::ranges::count(far_values(values, 0.1, 0.125), 1), 5);
  EXPECT_TRUE(far_values({}, 0.1).empty());
}

}  // namespace
}  // namespace coilwright::measurement::signals
