#include "video/course_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coilwright::video {
namespace {

constexpr double scatter = 1e-3;  // rad
constexpr double period = 1.0 / 120.0;

// `count` samples of an angle, and what the fits state of each, as a share of the scatter.
template <class Angle, class Stated>
std::vector<AngleSample> samples_of(int count, const Angle& angle, const Stated& stated) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, scatter);
  std::vector<AngleSample> out;
  for (int i = 0; i < count; ++i)
    out.push_back({.time = i * period, .angle = angle(i * period) + normal(random), .sigma = stated(i) * scatter});
  return with_shown_scatter(std::move(out), period);
}

double rms(const std::vector<AngleSample>& samples) {
  double sum = 0.0;
  for (const AngleSample& each : samples) sum += each.sigma * each.sigma / static_cast<double>(samples.size());
  return std::sqrt(sum);
}

double swing(double time) {
  return 0.4 * std::cos(20.0 * time);
}

// Beside errors that change slowly, of which there are none here, it states 1.22 times the scatter.
TEST(CourseScatter, IsThatOfTheAnglesWhateverTheFitsState) {
  for (const double stated : {0.4, 1.0, 4.0})
    EXPECT_NEAR(rms(samples_of(600, swing, [&](int) { return stated; })), 1.22 * scatter, 0.15 * scatter) << stated;
}

TEST(CourseScatter, KeepsWhichPicturesAreBetterThanOthers) {
  const auto samples = samples_of(150, swing, [](int i) { return i < 75 ? 1.0 : 4.0; });
  EXPECT_NEAR(samples[120].sigma, 4.0 * samples[30].sigma, 1e-9);
}

TEST(CourseScatter, OfAFingerAtRestIsThatAboutItsMean) {
  EXPECT_NEAR(rms(samples_of(
                  60, [](double) { return 0.2; }, [](int) { return 3.0; })),
              scatter, 0.2 * scatter);
}

// Twenty hertz, of 120 pictures a second: what the pictures do not follow is no scatter.
TEST(CourseScatter, IsNotAMotionThatThePicturesDoNotFollow) {
  const auto fast = [](double time) { return 0.3 * std::cos(125.0 * time); };
  EXPECT_LE(rms(samples_of(150, fast, [](int) { return 1.0; })), 1.0001 * scatter);
}

// As compression repeats it; and too few samples.
TEST(CourseScatter, LeavesToTheFitsWhatAnglesDoNotTell) {
  std::vector<AngleSample> frozen;
  for (int i = 0; i < 60; ++i)
    frozen.push_back({.time = i * period, .angle = 1e-4 * std::sin(0.05 * i), .sigma = scatter});
  EXPECT_NEAR(rms(with_shown_scatter(frozen, period)), scatter, 1e-9);
  EXPECT_NEAR(rms(samples_of(18, swing, [](int) { return 3.0; })), 3.0 * scatter, 1e-9);
}

}  // namespace
}  // namespace coilwright::video
