#include "measurement/noise/noise_colour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::noise {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> white_noise(std::size_t samples, double sigma, std::uint64_t seed) {
  Normal normal(seed);
  std::vector<double> out(samples);
  for (double& value : out) value = sigma * normal();
  return out;
}

// x(t) = r x(t - 1) + e(t), of unit variance.
std::vector<double> first_order_noise(std::size_t samples, double r, std::uint64_t seed) {
  Normal normal(seed);
  std::vector<double> out{normal()};
  while (out.size() < samples) out.push_back(r * out.back() + std::sqrt(1.0 - r * r) * normal());
  return out;
}

NoiseColour colour(const std::vector<double>& values, double interval) {
  const StillPiece piece{.values = values, .interval = interval};
  return colour_of(std::span(&piece, 1));
}

TEST(NoiseColour, FindsTheFrequencyAndTheAmplitudeOfHum) {
  constexpr double interval = 1.0 / 240.0;
  std::vector<double> values = white_noise(2400, 0.1, 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += 2.0 + 0.3 * std::sin(2.0 * pi * 50.0 * interval * static_cast<double>(i) + 0.4);
  const NoiseColour found = colour(values, interval);
  ASSERT_EQ(found.lines.size(), 1u);
  // Four standard deviations of the best estimate from 10 s: sqrt(6) / (pi T) sigma / (A sqrt(n)), sigma sqrt(2 / n).
  EXPECT_NEAR(found.lines.front().frequency, 50.0, 0.0022);
  EXPECT_NEAR(found.lines.front().amplitude, 0.3, 0.0116);
  EXPECT_NEAR(found.sigma, 0.1, 0.1 * 4.0 / std::sqrt(4800.0));
  EXPECT_TRUE(found.is_white);
}

TEST(NoiseColour, CallsWhiteNoiseWhiteAndFindsNoLineInIt) {
  int coloured = 0;
  int with_a_line = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const NoiseColour found = colour(white_noise(2000, 0.3, seed), 0.004);
    coloured += found.is_white ? 0 : 1;
    with_a_line += found.lines.empty() ? 0 : 1;
  }
  // Of the seeds up to 2000 49 are called coloured, where the limit aims at 20, and 12 have a line.
  EXPECT_LE(coloured, 5);
  EXPECT_LE(with_a_line, 1);
}

// A sum of filters with corners from 0.03 to 100 Hz: a spectrum near 1/f, steep over all of it, without a line.
TEST(NoiseColour, FindsNoLineInPinkNoise) {
  constexpr double interval = 1.0 / 120.0;
  int with_a_line = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    std::vector<double> values(1800);
    for (int filter = 0; filter < 8; ++filter) {
      const double corner = 0.03 * std::pow(100.0 / 0.03, filter / 7.0);
      const std::vector<double> part =
          first_order_noise(values.size(), std::exp(-2.0 * pi * corner * interval), 10 * seed + filter);
      for (std::size_t i = 0; i < values.size(); ++i) values[i] += part[i];
    }
    with_a_line += colour(values, interval).lines.empty() ? 0 : 1;
  }
  EXPECT_LE(with_a_line, 1);
}

TEST(NoiseColour, HasTheSpectrumOfFirstOrderNoise) {
  constexpr double r = 0.8;
  constexpr double interval = 0.01;
  const std::vector<double> first = first_order_noise(20000, r, 3);
  const std::vector<double> second = first_order_noise(15000, r, 4);
  const StillPiece pieces[] = {{.values = first, .interval = interval}, {.values = second, .interval = interval}};
  const NoiseColour found = colour_of(pieces);
  EXPECT_FALSE(found.is_white);
  EXPECT_TRUE(found.lines.empty());
  // Its variance is known as well as that of n (1 - r^2) / (1 + r^2) independent values.
  EXPECT_NEAR(found.sigma, 1.0, 4.0 / std::sqrt(2.0 * 35000.0 * (1.0 - r * r) / (1.0 + r * r)));
  for (const double frequency : {1.0, 3.0, 8.0, 20.0, 40.0}) {
    const double turn = std::cos(2.0 * pi * frequency * interval);
    const double density = (1.0 - r * r) / (1.0 - 2.0 * r * turn + r * r);
    EXPECT_NEAR(found.density_at(frequency), density, 0.1 * density) << frequency << " Hz";
  }
}

TEST(NoiseColour, BandsCoverAllFrequenciesWithoutGaps) {
  const NoiseColour found = colour(first_order_noise(4000, 0.5, 5), 0.01);
  EXPECT_EQ(found.bands.front().from, 0.0);
  EXPECT_NEAR(found.bands.back().to, 50.0, 1e-9);
  double freedom = 0.0;
  for (std::size_t i = 0; i < found.bands.size(); ++i) {
    if (i > 0) {
      EXPECT_EQ(found.bands[i].from, found.bands[i - 1].to);
    }
    EXPECT_GE(found.bands[i].freedom, 16.0);
    freedom += found.bands[i].freedom;
  }
  EXPECT_EQ(freedom, 3999.0);  // all coefficients but the mean
}

TEST(NoiseColour, NeedsThirtyTwoSamples) {
  try {
    (void)colour(white_noise(31, 1.0, 1), 0.01);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "a record of the noise needs at least 32 samples; got 31");
  }
}

}  // namespace
}  // namespace coilwright::measurement::noise
