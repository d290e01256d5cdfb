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

// Between two samples at 10 Hz and 0.7 A there is more than the noise, for several of them in a row.
TEST(InputNoise, OfAFastSineLeavesOneSine) {
  Normal normal(2);
  data::Run run{.name = "sine.csv", .kind = data::RunKind::transient, .drive = data::Drive::current};
  for (int i = 0; i < 250; ++i) {
    run.times.push_back(0.002 * i);
    run.inputs.push_back({0.7 + 0.7 * std::sin(20.0 * std::numbers::pi * run.times.back()) + sigma * normal()});
  }
  const auto clean = without_noise(run);
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->errors.size(), 4U);
}

// A chirp is as steep as an edge for most of its time, and one command that has no edge: cut at its steepest parts it
// would have hundreds of errors, each with a derivative of its own.
TEST(InputNoise, OfAChirpLeavesOnePiece) {
  constexpr double noise = 0.01;
  const auto chirp = [](double time) {
    return 0.7 + 0.7 * std::sin(2.0 * std::numbers::pi * (0.5 * time + 0.5 * 19.5 / 8.0 * time * time));
  };
  Normal normal(3);
  data::Run run{.name = "chirp.csv", .kind = data::RunKind::transient, .drive = data::Drive::current};
  for (int i = 0; i < 1600; ++i) {
    run.times.push_back(0.005 * i);
    run.inputs.push_back({chirp(run.times.back()) + noise * normal()});
  }
  const auto clean = without_noise(run);
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->errors.size(), 0U);
  double squares = 0.0;
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    const double error = clean->rows[i][0] - chirp(run.times[i]);
    squares += error * error;
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(run.times.size())), noise);
}

// Records of two levels: those of the first thousand whose noise is estimated so low that a constant would not pass if
// the estimate were exact, and one other.
TEST(InputNoise, LeavesLevelsOfWhichEachKeepsOneError) {
  for (const unsigned seed : {1U, 285U, 324U, 422U, 618U, 720U, 887U, 972U}) {
    Normal normal(seed);
    data::Run run{.name = "release.csv", .kind = data::RunKind::transient, .drive = data::Drive::current};
    for (int i = 0; i < 400; ++i) {
      run.times.push_back(0.002 * i);
      run.inputs.push_back({(i < 32 ? 1.4 : 0.0) + sigma * normal()});
    }
    const auto clean = without_noise(run);
    ASSERT_TRUE(clean);
    EXPECT_EQ(clean->errors.size(), 2U) << seed;
    // Exactly constant, which simulations pass over in long steps.
    for (const std::size_t held : {31U, 399U}) EXPECT_EQ(clean->rows[held], clean->rows[held - 31]) << seed;
  }
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
