#include "measurement/replay/input_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr double sigma = 0.02;  // A

// Steps of 1 A every half second, and a slow sine, at 500 samples a second.
double command(double time) {
  return (std::fmod(time, 1.0) < 0.5 ? 0.0 : 1.0) + 0.3 * std::sin(2.0 * std::numbers::pi * 0.7 * time);
}

data::Run record(double noise) {
  Normal normal(1);
  data::Run run{.name = "a.csv", .kind = data::RunKind::transient, .drive = data::Drive::current};
  for (int i = 0; i < 1500; ++i) {
    run.times.push_back(0.002 * i);
    run.inputs.push_back({command(run.times.back()) + noise * normal()});
  }
  return run;
}

TEST(InputNoise, IsTakenOutBetweenEdgesThatStaySharp) {
  const data::Run run = record(sigma);
  const auto clean = without_noise(run);
  ASSERT_TRUE(clean);
  EXPECT_NEAR(clean->sigma, sigma, 0.1 * sigma);
  double squares = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    const double error = clean->rows[i][0] - command(run.times[i]);
    squares += error * error;
    largest = std::max(largest, std::abs(error));
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(run.times.size())), 0.35 * sigma);
  EXPECT_LT(largest, 3.0 * sigma);  // a blurred edge would be off by half an ampere
}

TEST(InputNoise, IsNotInACommand) {
  EXPECT_FALSE(without_noise(record(0.0)));
  // A logger's resolution is no noise.
  data::Run steps = record(0.0);
  for (auto& row : steps.inputs) row[0] = std::round(row[0] / 0.02) * 0.02;
  EXPECT_FALSE(without_noise(steps));
}

}  // namespace
}  // namespace coilwright::measurement::replay
