#include "measurement/signals/whittaker_smoother.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::signals {
namespace {

using std::numbers::pi;

std::vector<double> uneven(int count, std::uint64_t seed) {
  Normal normal(seed);
  std::vector<double> times{0.0};
  while (static_cast<int>(times.size()) < count) times.push_back(times.back() + 0.002 * (0.6 + 0.8 * normal.uniform()));
  return times;
}

TEST(WhittakerSmoother, LetsParabolasPass) {
  const std::vector<double> times = uneven(300, 1);
  std::vector<double> values;
  for (const double t : times) values.push_back(0.3 - 2.0 * t + 5.0 * t * t);
  const std::vector<double> smooth = smoothed(times, values, 1e8);
  const Derivatives slopes = derivatives(times, smooth);
  // 1e8 times the rounding of a double, 1e-16, spread by the band.
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(smooth[i], values[i], 1e-7);
  for (std::size_t i = 1; i + 1 < times.size(); ++i) EXPECT_NEAR(slopes.first[i], -2.0 + 10.0 * times[i], 1e-4);
}

TEST(WhittakerSmoother, HasTheDocumentedGain) {
  constexpr int count = 4000;
  constexpr double interval = 0.002;
  for (const double frequency : {3.0, 8.0, 12.0}) {
    std::vector<double> times, values;
    for (int i = 0; i < count; ++i) {
      times.push_back(interval * i);
      values.push_back(std::sin(2.0 * pi * frequency * times.back()));
    }
    constexpr double penalty = 1e6;
    const std::vector<double> smooth = smoothed(times, values, penalty);
    double product = 0.0;
    double square = 0.0;
    for (int i = 500; i < count - 500; ++i) {
      product += smooth[i] * values[i];
      square += values[i] * values[i];
    }
    const double gain = 1.0 / (1.0 + penalty * std::pow(2.0 * std::sin(pi * frequency * interval), 6));
    EXPECT_NEAR(product / square, gain, 1e-6) << frequency;
  }
}

TEST(WhittakerSmoother, ChoosesNearlyTheLeastError) {
  constexpr double sigma = 0.005;
  Normal normal(2);
  std::vector<double> times, truth, values;
  for (int i = 0; i < 2000; ++i) {
    times.push_back(0.002 * i);
    truth.push_back(0.1 * std::sin(2.0 * pi * 1.7 * times.back()));
    values.push_back(truth.back() + sigma * normal());
  }
  const auto error = [&](double penalty) {
    const std::vector<double> smooth = smoothed(times, values, penalty);
    double sum = 0.0;
    for (std::size_t i = 0; i < smooth.size(); ++i) sum += (smooth[i] - truth[i]) * (smooth[i] - truth[i]);
    return std::sqrt(sum / 2000.0);
  };
  double least = 1.0;
  for (int half_decade = 0; half_decade <= 24; ++half_decade)
    least = std::min(least, error(std::pow(10.0, 0.5 * half_decade)));
  const std::vector<SampledSegment> whole{{times, values}};
  EXPECT_LT(error(best_penalty(whole, sigma)), 1.3 * least);
  EXPECT_LT(least, 0.2 * sigma);
}

}  // namespace
}  // namespace coilwright::measurement::signals
