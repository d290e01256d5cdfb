#include "measurement/replay/command_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr double current_noise = 0.02;  // A

struct Readings {
  std::vector<double> times{}, true_values{}, values{};
};

Readings read(int samples, const std::function<double(double)>& command, unsigned seed) {
  Normal normal(seed);
  Readings out;
  for (int i = 0; i < samples; ++i) {
    out.times.push_back(0.002 * i);
    out.true_values.push_back(command(out.times.back()));
    out.values.push_back(out.true_values.back() + current_noise * normal());
  }
  return out;
}

// Squared error of the curve over sigma^2, the mean of many draws: as many as it has numbers.
double mean_squared_error(int samples, const std::function<double(double)>& command, Eigen::Index numbers) {
  constexpr int draws = 40;
  double sum = 0.0;
  for (unsigned seed = 1; seed <= draws; ++seed) {
    const Readings readings = read(samples, command, seed);
    const auto shape = command_shape(readings.times, readings.values, {.sigma = current_noise});
    EXPECT_TRUE(shape) << seed;
    if (!shape) return 0.0;
    EXPECT_EQ(shape->basis.cols(), numbers) << seed;
    for (int i = 0; i < samples; ++i)
      sum += std::pow((shape->values[i] - readings.true_values[static_cast<std::size_t>(i)]) / current_noise, 2);
  }
  return sum / draws;
}

// A chi-square of as many degrees of freedom as numbers, over 40 draws: within four deviations of its mean.
void expect_error_of(double found, double numbers) {
  EXPECT_NEAR(found, numbers, 4.0 * std::sqrt(2.0 * numbers / 40.0));
}

TEST(CommandShape, IsAConstantARampOrASineWithTheErrorOfItsNumbers) {
  expect_error_of(mean_squared_error(
                      400, [](double) { return 1.2; }, 1),
                  1.0);
  expect_error_of(mean_squared_error(
                      400, [](double t) { return 0.3 + t; }, 2),
                  2.0);
  const auto sine = [](double frequency) {
    return [=](double t) { return 0.7 + 0.7 * std::sin(2.0 * std::numbers::pi * frequency * t); };
  };
  expect_error_of(mean_squared_error(500, sine(10.0), 4), 4.0);
  expect_error_of(mean_squared_error(500, sine(3.3), 4), 4.0);
}

// One period and a little less: the period that was commanded lies off the lines of the spectrum.
TEST(CommandShape, IsASineOfOnePeriod) {
  const auto one = [](double t) { return 0.7 + 0.7 * std::sin(2.0 * std::numbers::pi * t); };
  expect_error_of(mean_squared_error(500, one, 4), 4.0);
}

TEST(CommandShape, IsNothingForACurveOfMoreNumbers) {
  const auto chirp = [](double t) { return std::sin(2.0 * std::numbers::pi * (1.0 + 2.0 * t) * t); };
  const Readings readings = read(1000, chirp, 3);
  EXPECT_FALSE(command_shape(readings.times, readings.values, {.sigma = current_noise}));
  const Readings few = read(
      7, [](double) { return 1.0; }, 3);
  EXPECT_FALSE(command_shape(few.times, few.values, {.sigma = current_noise}));
}

// A level that is known to a tenth may be a fifth too low; one that is exact may not.
TEST(CommandShape, BearsWithALevelThatIsAnEstimate) {
  const Readings readings = read(
      370, [](double) { return 0.4; }, 7);
  const double low = 0.82 * current_noise;
  EXPECT_FALSE(command_shape(readings.times, readings.values, {.sigma = low}));
  const auto shape = command_shape(readings.times, readings.values, {.sigma = low, .freedom = 50.0});
  ASSERT_TRUE(shape);
  EXPECT_EQ(shape->basis.cols(), 1);
  // What is no constant is none with a level as uncertain, either.
  const Readings bent = read(
      370, [](double t) { return 0.1 * std::sin(40.0 * t * t); }, 7);
  EXPECT_FALSE(command_shape(bent.times, bent.values, {.sigma = low, .freedom = 50.0}));
}

TEST(CommandShape, HasOrthonormalColumnsThatSpanItsCurve) {
  const Readings readings = read(
      300, [](double t) { return 0.2 - t * t; }, 5);
  const auto shape = command_shape(readings.times, readings.values, {.sigma = current_noise});
  ASSERT_TRUE(shape);
  const Eigen::Index k = shape->basis.cols();
  EXPECT_EQ(k, 3);
  EXPECT_TRUE((shape->basis.transpose() * shape->basis).isApprox(Eigen::MatrixXd::Identity(k, k), 1e-12));
  EXPECT_TRUE((shape->basis * (shape->basis.transpose() * shape->values)).isApprox(shape->values, 1e-12));
}

}  // namespace
}  // namespace coilwright::measurement::replay
