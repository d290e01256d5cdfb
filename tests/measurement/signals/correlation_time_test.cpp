#include "coilwright/measurement/signals/correlation_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "measurement/signals/residual_draws.hpp"

namespace coilwright::measurement::signals {
namespace {

TEST(CorrelationTime, OfWhiteNoiseIsOne) {
  for (int seed = 1; seed <= 5; ++seed) {
    Normal normal(seed);
    // Five lags of correlations +-1/sqrt(12000) each, twice: 0.04.
    EXPECT_NEAR(correlation_time(white_set(10, 1200, normal)), 1.0, 0.12);
  }
}

TEST(CorrelationTime, OfAGaussMarkovProcessIsKnown) {
  for (const double samples : {5.0, 30.0}) {
    Normal normal(4);
    const ScaledResidual one{.run = "a", .values = markov(60000, samples, normal)};
    const double keep = std::exp(-1.0 / samples);
    const double exact = (1.0 + keep) / (1.0 - keep);
    // Relative standard error sqrt(2 (2 W + 1) / n) with W = 5 tau (Sokal): 10 % at tau = 60.
    EXPECT_NEAR(correlation_time(std::vector{one}) / exact, 1.0, 3.0 * std::sqrt(20.0 * exact / 60000.0)) << samples;
  }
}

TEST(CorrelationTime, DoesNotReachAcrossTheStartOfAWindow) {
  // Windows of constants with random signs: equal inside a window, independent across windows.
  Normal normal(5);
  ScaledResidual residual{.run = "a", .starts = {}};
  for (std::size_t w = 0; w < 200; ++w) {
    residual.starts.push_back(10 * w);
    residual.values.insert(residual.values.end(), 10, normal() < 0.0 ? -1.0 : 1.0);
  }
  // 1 + 2 sum over lags 1 to 9 of (10 - lag) / 10 = 10: a window counts as one sample.
  EXPECT_NEAR(correlation_time(std::vector{residual}), 10.0, 1e-9);
}

TEST(CorrelationTime, OfAnOffsetIsTheLengthOfTheRun) {
  const ScaledResidual residual{.run = "a", .values = std::vector<double>(400, 2.0)};
  EXPECT_NEAR(correlation_time(std::vector{residual}), 400.0, 1e-9);
  EXPECT_EQ(correlation_time(std::vector<ScaledResidual>{{.run = "a", .values = {0.0, 0.0}}}), 1.0);
}

}  // namespace
}  // namespace coilwright::measurement::signals
