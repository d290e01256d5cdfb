#include "coilwright/video/film_clock.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
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

// Of the pictures after the finger began to move, the first is number 0.
struct Fault {
  const char* name;
  int first;
  int last;
  bool doubled;  // shows the picture before once more, in place of its own; otherwise it is not read
};

// A finger that is let go at `start`: rates of 12 to 40 rad/s, 8 to 38 degrees, noise of 0.03 to 0.25 degrees, in every
// other trace compression holds what is still.
std::vector<AngleSample> faulty_trace(double rate, double start, const Fault& fault, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> between(0.0, 1.0);
  constexpr std::array speeds = {12.0, 25.0, 40.0};
  constexpr std::array noises = {5e-4, 1.7e-3, 4.4e-3};
  const double speed = speeds[random() % 3], noise = noises[random() % 3];
  const double decay = speed * (0.05 + 0.5 * between(random)), way = 0.14 + 0.52 * between(random);
  const bool held = random() % 2 == 0;
  std::vector<AngleSample> out;
  for (int i = 0; i < 1.2 * rate; ++i) {
    const int since = i - static_cast<int>(std::ceil(start * rate));
    const bool faulty = since >= fault.first && since <= fault.last;
    const double time = std::max(0.0, i / rate - start);
    const double step =
        way * (1.0 - std::exp(-decay * time) * (std::cos(speed * time) + decay / speed * std::sin(speed * time)));
    const double error = (held && since < 0 ? 0.1 : 1.0) * noise * normal(random);
    if (faulty && !fault.doubled) continue;
    out.push_back({.time = i / rate, .angle = 0.3 + step + error, .sigma = noise});
    if (faulty) out.back().angle = std::prev(out.end(), 2)->angle + 0.05 * error;
  }
  return out;
}

// Prints a table.
TEST(FilmClock, StatesHowWellABeginIsKnownWherePicturesAreDoubledOrNotRead) {
  constexpr std::array faults = {Fault{"none", 99, 98, false},         Fault{"1 doubled before", -1, -1, true},
                                 Fault{"1 doubled at", 0, 0, true},    Fault{"1 doubled after", 1, 1, true},
                                 Fault{"2 doubled after", 1, 2, true}, Fault{"1 unread after", 0, 0, false},
                                 Fault{"2 unread after", 0, 1, false}, Fault{"3 unread about", -1, 1, false}};
  for (const Fault& fault : faults)
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
      std::mt19937 random(7);
      constexpr int films = 16;
      int far = 0, beyond = 0, open = 0;
      for (int film = 0; film < films; ++film) {
        const double start = 0.5 + (film + 0.5) / films / rate;
        const auto onset = onset_of(faulty_trace(rate, start, fault, random), 1.0 / rate);
        ASSERT_TRUE(onset);
        const double error = std::abs(onset->time - start);
        if (!is_known_to_two_pictures(*onset, 1.0 / rate)) {
          ++open;
          continue;
        }
        far += error > 2.0 / rate ? 1 : 0;
        beyond += error > 2.0 * onset->sigma ? 1 : 0;
      }
      std::printf("%-17s %3.0f Hz of %d: off by two pictures %d, by two deviations %d; not known %d\n", fault.name,
                  rate, films, far, beyond, open);
      // The deviation has an interval for what no picture shows, so that fewer than one in 20 are beyond two of it.
      EXPECT_EQ(far, 0) << fault.name << rate;
      EXPECT_LE(beyond, 1) << fault.name << rate;
      EXPECT_LE(open, 2) << fault.name << rate;
    }
}

TEST(FilmClock, KnowsNoBeginThatTooManyPicturesHide) {
  std::mt19937 random(3);
  const auto hidden = faulty_trace(30.0, 0.51, {"", -2, 5, false}, random);
  const auto onset = onset_of(hidden, 1.0 / 30.0);
  ASSERT_TRUE(onset);
  EXPECT_FALSE(is_known_to_two_pictures(*onset, 1.0 / 30.0));
}

TEST(FilmClock, SeesNoOnsetInAFilmThatBeginsInAMotion) {
  auto samples = started_at(0.3);
  samples.erase(samples.begin(), samples.begin() + 45);  // from 0.375 s on
  EXPECT_FALSE(onset_of(samples, interval));
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
  const auto lit = led_lit(film, motion, Place(300.0, 119.5));
  ASSERT_TRUE(lit);
  // 30 % of an exposure of 4 ms: 0.2 of it after the middle; row 120 of 480 is exposed a quarter of 10 ms before that.
  EXPECT_NEAR(lit->time, 7 * interval + 0.2 * 4e-3 - 0.25 * 0.01, 1e-9);
}

TEST(FilmClock, StatesHowWellALedIsKnownThatIsLitWherePicturesAreMissing) {
  TrackedFilm film{.width = 640, .height = 480};
  for (int i = 0; i < 20; ++i)
    if (i < 7 || i > 9) film.frames.push_back({.time = i * interval, .led = i < 9 ? 20.0 : 220.0});
  const auto lit = led_lit(film, {.interval = interval}, Place(300.0, 239.5));
  ASSERT_TRUE(lit);
  EXPECT_NEAR(lit->time, 8.0 * interval, 1e-9);
  EXPECT_NEAR(lit->sigma, 4.0 * interval / std::sqrt(12.0), 1e-9);  // anywhere between pictures 6 and 10
}

TEST(FilmClock, SeesNoLedWhoseLightDoesNotChange) {
  TrackedFilm film{.width = 640, .height = 480};
  for (int i = 0; i < 20; ++i) film.frames.push_back({.time = i * interval, .led = 100.0 + i % 3});
  EXPECT_FALSE(led_lit(film, {.interval = interval}, Place(300.0, 119.5)));
}

}  // namespace
}  // namespace coilwright::video
