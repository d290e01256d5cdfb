#include "coilwright/video/film_clock.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace coilwright::video {
namespace {

constexpr double interval = 1.0 / 120.0;
constexpr double sigma = 1e-3;

// At rest until `start`, then under a constant acceleration of 40 rad/s^2, with noise of `sigma`.
std::vector<AngleSample> started_at(double start, double until = 0.6) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0.0, sigma);
  std::vector<AngleSample> out;
  for (double time = 0.0; time < until; time += interval) {
    const double since = std::max(0.0, time - start);
    out.push_back({.time = time, .angle = 0.3 + 20.0 * since * since + normal(random), .sigma = sigma});
  }
  return out;
}

TEST(FilmClock, SeesWhenATagBeginsToMoveBetweenTwoPictures) {
  for (const double start : {0.3011, 0.3043, 0.3082}) {
    const auto onset = onset_of(started_at(start), interval);
    ASSERT_TRUE(onset);
    // 1e-3 rad of noise on the 5e-3 to 2e-2 rad of the six pictures that count are 1.6 to 0.8 ms of their times.
    EXPECT_NEAR(onset->time, start, 0.25 * interval);
    EXPECT_GE(onset->sigma, interval);
    EXPECT_LT(onset->sigma, 1.2 * interval);
  }
}

// The tip of a finger of two joints starts faster than it goes on: the root of its way is no line.
TEST(FilmClock, SeesWhenATipOfTwoJointsBeginsToMove) {
  // Way of the paper's finger, with air drag, degrees, every 4 ms after a step to 1.2 A: the ideal record of a twin of
  // film_loop_test.py.
  constexpr std::array way = {0.0, 1.56, 4.76, 8.65, 13.10, 18.04, 23.34, 28.80, 34.21, 39.40};
  constexpr double fast = 1.0 / 240.0;
  for (const double start : {0.3005, 0.3017, 0.3031}) {
    std::vector<AngleSample> samples;
    for (double time = 0.0; time < start + 0.035; time += fast) {
      const double steps = std::max(0.0, (time - start) / 0.004);
      const auto k = static_cast<std::size_t>(steps);
      const double degrees = way[k] + (steps - static_cast<double>(k)) * (way[k + 1] - way[k]);
      samples.push_back({.time = time, .angle = degrees * M_PI / 180.0, .sigma = 0.12 * M_PI / 180.0});
    }
    const auto onset = onset_of(samples, fast);
    ASSERT_TRUE(onset);
    EXPECT_NEAR(onset->time, start, onset->sigma);
  }
}

// Compression freezes what is still: its errors creep by more than the small deviation that its pixels state.
TEST(FilmClock, TakesNoCreepingOfAFrozenPictureForAMotion) {
  constexpr double start = 0.3043;
  auto samples = started_at(start);
  for (AngleSample& each : samples)
    if (each.time < start) {
      each.sigma = 0.1 * sigma;
      each.angle = 0.3 + (each.time > 0.2 ? 2.0 * sigma : 0.0);
    }
  EXPECT_LT(samples[still_samples(samples)].time, 0.22);
  const auto onset = onset_of(samples, interval);
  ASSERT_TRUE(onset);
  EXPECT_NEAR(onset->time, start, 2.5e-3);  // as above, and 1e-3 rad of the rest's own error
}

TEST(FilmClock, SeesNoOnsetWhereNothingMoves) {
  const auto still = started_at(10.0);
  EXPECT_EQ(still_samples(still), still.size());
  EXPECT_FALSE(onset_of(still, interval));
}

TEST(FilmClock, TellsALedThatIsLitDuringAnExposure) {
  TrackedFilm film{.width = 640, .height = 480};
  for (int i = 0; i < 20; ++i)
    film.frames.push_back({.time = i * interval, .led = i < 7 ? 20.0 : (i == 7 ? 80.0 : 220.0)});
  const FingerMotion motion{.interval = interval, .readout = {.value = 0.01}, .exposure = {.value = 4e-3}};
  const auto lit = led_lit(film, motion, 120.0);
  ASSERT_TRUE(lit);
  // 30 % of an exposure of 4 ms: 0.2 of it after the middle; row 120 of 480 is exposed a quarter of 10 ms before that.
  EXPECT_NEAR(lit->time, 7 * interval + 0.2 * 4e-3 - 0.25 * 0.01, 1e-9);
}

TEST(FilmClock, SeesNoLedWhoseLightDoesNotChange) {
  TrackedFilm film{.width = 640, .height = 480};
  for (int i = 0; i < 20; ++i) film.frames.push_back({.time = i * interval, .led = 100.0 + i % 3});
  EXPECT_FALSE(led_lit(film, {.interval = interval}, 120.0));
}

}  // namespace
}  // namespace coilwright::video
