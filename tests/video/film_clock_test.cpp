#include "coilwright/video/film_clock.hpp"

#include <gtest/gtest.h>

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
    // 1e-3 rad of noise on the 6e-2 rad of the last picture that counts are 0.5 ms of its time.
    EXPECT_NEAR(onset->time, start, 1.5e-3);
    EXPECT_EQ(onset->sigma, interval);
  }
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
