#include "measurement/signals/pooled_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "degree.hpp"

namespace coilwright::measurement::signals {
namespace {

// What runs of such freedom would say of instruments of such noise: s² f / sigma² is chi-square of f.
std::vector<NoiseLevel> drawn(const std::vector<double>& sigmas, double freedom, unsigned seed) {
  std::mt19937 random(seed);
  std::chi_squared_distribution<double> energy(freedom);
  std::vector<NoiseLevel> out;
  for (const double sigma : sigmas)
    out.push_back({.sigma = sigma * std::sqrt(energy(random) / freedom), .from_the_run = true, .freedom = freedom});
  return out;
}

void pool(std::vector<NoiseLevel>& levels) {
  std::vector<NoiseLevel*> all;
  for (NoiseLevel& level : levels) all.push_back(&level);
  pool_levels(all);
}

double rms_error_of_logarithm(const std::vector<NoiseLevel>& levels, const std::vector<double>& sigmas) {
  double sum = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) sum += std::pow(std::log(levels[i].sigma / sigmas[i]), 2);
  return std::sqrt(sum / static_cast<double>(levels.size()));
}

TEST(PooledLevels, ShortRunsOfOneInstrumentAreKnownFromEachOther) {
  const std::vector<double> sigmas(10, 0.3 * degree);
  double before = 0.0;
  double after = 0.0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::vector<NoiseLevel> levels = drawn(sigmas, 6.0, seed);
    before += std::pow(rms_error_of_logarithm(levels, sigmas), 2) / 200.0;
    pool(levels);
    after += std::pow(rms_error_of_logarithm(levels, sigmas), 2) / 200.0;
  }
  RecordProperty("error_before", std::to_string(std::sqrt(before)));
  RecordProperty("error_after", std::to_string(std::sqrt(after)));
  EXPECT_GT(std::sqrt(before), 0.29);  // 1 / sqrt(2 f), and the tail of small chi-squares
  EXPECT_LT(std::sqrt(after), 0.15);   // all 60 together: 0.09
}

// A run of 60 pictures that chance has shown little of its noise was left out of its set in one set of ten, and weighed
// three times what it should.
TEST(PooledLevels, LeaveARunOutByChanceInOneSetOfAHundred) {
  const std::vector<double> sigmas(10, 0.3 * degree);
  int sets = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::vector<NoiseLevel> levels = drawn(sigmas, 17.0, seed);
    pool(levels);
    sets += std::ranges::any_of(levels, [](const NoiseLevel& level) { return level.source.empty(); }) ? 1 : 0;
  }
  EXPECT_GT(sets, 1);
  EXPECT_LT(sets, 25);
}

TEST(PooledLevels, RunsThatTrulyDifferAreNotMadeEqual) {
  std::vector<double> sigmas;
  for (int i = 0; i < 10; ++i) sigmas.push_back(0.2 * degree * std::pow(1.15, i));
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::vector<NoiseLevel> levels = drawn(sigmas, 1000.0, seed);
    const double before = rms_error_of_logarithm(levels, sigmas);
    pool(levels);
    EXPECT_LT(rms_error_of_logarithm(levels, sigmas), 1.3 * before) << seed;
  }
}

TEST(PooledLevels, OneThatSeesMotionStaysAsItIsAndMovesNoOther) {
  const std::vector<double> sigmas(9, 0.3 * degree);
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::vector<NoiseLevel> levels = drawn(sigmas, 12.0, seed);
    std::vector<NoiseLevel> without = levels;
    levels.push_back({.sigma = 2.0 * degree, .from_the_run = true, .freedom = 6.0});
    pool(levels);
    pool(without);
    EXPECT_DOUBLE_EQ(levels.back().sigma, 2.0 * degree);
    EXPECT_FALSE(levels.back().pooled);
    for (std::size_t i = 0; i < without.size(); ++i) EXPECT_NEAR(levels[i].sigma / without[i].sigma, 1.0, 1e-12);
  }
}

TEST(PooledLevels, AreNeverBelowTheRounding) {
  std::vector<NoiseLevel> levels = drawn(std::vector<double>(6, 0.01 * degree), 20.0, 1);
  levels.front().resolution = 0.1 * degree;
  levels.front().sigma = 0.011 * degree;
  pool(levels);
  EXPECT_DOUBLE_EQ(levels.front().sigma, levels.front().of_rounding());
}

TEST(PooledLevels, TwoRunsAreLeftAsTheyAre) {
  std::vector<NoiseLevel> levels = drawn({0.3 * degree, 0.3 * degree}, 6.0, 1);
  const double first = levels.front().sigma;
  pool(levels);
  EXPECT_EQ(levels.front().sigma, first);
  EXPECT_FALSE(levels.front().pooled);
}

}  // namespace
}  // namespace coilwright::measurement::signals
