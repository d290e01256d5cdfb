#include "measurement/localise/spectral_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::localise {
namespace {

using std::numbers::pi;

TEST(StrongestSpectralLine, IsNotFoundInNoise) {
  int seen = 0;
  for (int seed = 1; seed <= 100; ++seed) {
    std::vector<EvenSeries> series;
    for (int r = 0; r < 3; ++r) series.push_back({0.01, normal_deviates(600, 10 * seed + r)});
    seen += strongest_spectral_line(series) ? 1 : 0;
  }
  // 1 in 100 in theory; the medians by which spectra are normalised are estimates themselves.
  EXPECT_LE(seen, 6);
}

TEST(StrongestSpectralLine, PrefersALineThatAllRunsShare) {
  std::vector<EvenSeries> series;
  for (int r = 0; r < 4; ++r) {
    series.push_back({0.01, normal_deviates(1000, 50 + r)});
    for (int i = 0; i < 1000; ++i) {
      series.back().values[i] += 0.6 * std::sin(2.0 * pi * 7.0 * 0.01 * i + r);
      if (r == 2) series.back().values[i] += 2.0 * std::sin(2.0 * pi * 2.3 * 0.01 * i);
    }
  }
  ASSERT_TRUE(strongest_spectral_line(series));
  EXPECT_NEAR(*strongest_spectral_line(series), 7.0, 0.05);  // half of what ten seconds resolve
}

TEST(StrongestSpectralLine, NeedsEnoughSamples) {
  EXPECT_FALSE(strongest_spectral_line({}));
  EXPECT_FALSE(strongest_spectral_line(std::vector<EvenSeries>{{0.01, normal_deviates(63, 1)}}));
}

}  // namespace
}  // namespace coilwright::measurement::localise
