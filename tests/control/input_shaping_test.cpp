#include "coilwright/control/input_shaping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "error_text.hpp"

namespace coilwright::control {
namespace {

constexpr double pi = std::numbers::pi;

// What a linear mode vibrates with after the last piece of a profile, over what it does after the same step unshaped:
// each change of the current starts exp((-zeta + i sqrt(1 - zeta^2)) w (t - t_i)), by superposition.
double left_over(const CurrentProfile& profile, double frequency, double damping) {
  const std::complex<double> pole =
      2.0 * pi * frequency * std::complex<double>(-damping, std::sqrt(1.0 - damping * damping));
  const double end = profile.times.back();
  std::complex<double> sum = 0.0;
  double before = profile.before;
  for (std::size_t i = 0; i < profile.times.size(); ++i) {
    sum += (profile.levels[i] - before) * std::exp(pole * (end - profile.times[i]));
    before = profile.levels[i];
  }
  return std::abs(sum / (profile.last() - profile.before));
}

TEST(ShapedStep, LeavesNothingOfTheModeItIsMadeFor) {
  for (const double damping : {0.01, 0.083, 0.45, 0.9}) {
    const simulation::Mode mode{.natural_frequency = 7.3, .damping_ratio = damping};
    EXPECT_NEAR(left_over(shaped_step(0.1, 0.9, mode, Shaper::zero_vibration), 7.3, damping), 0.0, 1e-12);
    EXPECT_NEAR(left_over(shaped_step(0.1, 0.9, mode, Shaper::zero_vibration_derivative), 7.3, damping), 0.0, 1e-12);
  }
}

// Singer and Seering 1990: without damping, an error e of the frequency leaves sin(pi e / 2) and its square.
TEST(ShapedStep, LeavesALittleOfAModeThatIsOff) {
  const simulation::Mode mode{.natural_frequency = 10.0, .damping_ratio = 1e-9};
  for (const double error : {-0.2, -0.05, 0.1}) {
    const double sine = std::sin(0.5 * pi * error);
    EXPECT_NEAR(left_over(shaped_step(0.0, 1.0, mode, Shaper::zero_vibration), 10.0 * (1.0 + error), 1e-9),
                std::abs(sine), 1e-6);
    EXPECT_NEAR(left_over(shaped_step(0.0, 1.0, mode, Shaper::zero_vibration_derivative), 10.0 * (1.0 + error), 1e-9),
                sine * sine, 1e-6);
  }
}

TEST(ShapedStep, EndsWhereItShouldByStepsInOneDirection) {
  const simulation::Mode mode{.natural_frequency = 5.0, .damping_ratio = 0.2};
  for (const Shaper shaper : {Shaper::zero_vibration, Shaper::zero_vibration_derivative}) {
    const CurrentProfile down = shaped_step(1.2, -0.3, mode, shaper);
    EXPECT_EQ(down.last(), -0.3);
    EXPECT_EQ(down.times.front(), 0.0);
    double before = down.before;
    for (const double level : down.levels) {
      EXPECT_LT(level, before);
      before = level;
    }
  }
  EXPECT_EQ(shaped_step(0.0, 1.0, mode, Shaper::step).levels, std::vector<double>{1.0});
}

TEST(ShapedStep, LeavesWhatDoesNotOscillateWhole) {
  EXPECT_EQ(
      shaped_step(0.0, 1.0, {.natural_frequency = 5.0, .damping_ratio = 1.0}, Shaper::zero_vibration).times.size(), 1u);
}

TEST(ShapedStep, RejectsWhatIsNoMode) {
  EXPECT_EQ(
      error_text([] { (void)shaped_step(0.0, 1.0, {.natural_frequency = 5.0, .damping_ratio = -0.1}, Shaper::step); }),
      "mode must have a frequency and a damping ratio > 0; got 5 Hz and -0.1");
}

}  // namespace
}  // namespace coilwright::control
