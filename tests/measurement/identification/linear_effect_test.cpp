#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/linear_screening.hpp"
#include "measurement/identification/profile_likelihood.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/slider_model.hpp"

// A sensor's zero adds one number to every reading: what screening and profile say of it follows by hand.
namespace coilwright::measurement::identification {
namespace {

constexpr std::size_t readings = 100;
constexpr double shifted_zero = 0.005;     // rad, five times the noise
constexpr double simulation_error = 1e-3;  // relative error of what an integrator of 1e-7 and a noise of 1e-3 leave

// The slide, of which nothing is fitted.
replay::DeclaredModel known_slide() {
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  declared.calibration.clear();
  declared.build = [](std::span<const double> /*values*/) {
    return slide(true_mass, true_damping).build(std::vector{true_mass, true_damping});
  };
  return declared;
}

struct Shifted {
  const actuator::EffectKind& kind = *actuator::standard_effects().find("angle_offset");
  replay::DeclaredModel declared = known_slide();
  data::Run run = slide_run(readings, {}, [] { return shifted_zero; });
  std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, model_of(declared))};
};

TEST(LinearScreening, PredictsTheWholeFallOfALinearEffectFromEitherSide) {
  const Shifted shifted;
  const fit::Hypothesis plain(shifted.declared, {});
  auto there = fit::evaluate_with_jacobian({.hypothesis = &plain, .runs = shifted.runs, .start = plain.start()});
  ASSERT_TRUE(there);
  const FittedHypothesis base = score(shifted.runs, plain, std::move(*there));
  const double chi_square = static_cast<double>(readings) * (shifted_zero / noise_sigma) * (shifted_zero / noise_sigma);
  EXPECT_NEAR(base.fit.chi_square, chi_square, simulation_error * chi_square);
  const std::vector<const actuator::EffectKind*> kinds{&shifted.kind};
  const auto screened = screen_effects(shifted.runs, base,
                                       {.kinds = kinds, .scale = rig_scale(shifted.runs, model_of(shifted.declared))});
  ASSERT_EQ(screened.size(), 2u);  // one degree up and one down
  for (const ScreenedEffect& each : screened) {
    EXPECT_NEAR(each.predicted_chi_square_fall, chi_square, simulation_error * chi_square);
    EXPECT_NEAR(each.effect.values[0], shifted_zero, simulation_error * shifted_zero);
  }
  EXPECT_NEAR(screened[0].predicted_share, -screened[1].predicted_share, simulation_error);
}

// Ten degrees, the most that its zero may be off, move chi-square by n (10 deg / sigma)^2. An effect that would move it
// by half as much as an optimum is known to is not tested; one that would move it by twice as much is, weak as it is.
TEST(LinearScreening, LeavesOutWhatNoStrengthWouldShow) {
  constexpr double most = 10.0 / 180.0 * std::numbers::pi;
  for (const double fall : {0.05, 0.2}) {
    Shifted shifted;
    shifted.run.sigma = most * std::sqrt(static_cast<double>(readings) / fall);
    shifted.runs = {replay::prepare_run(shifted.run, shifted.declared, model_of(shifted.declared))};
    const FittedHypothesis base = fitted_to(shifted.runs, shifted.declared, {});
    const std::vector<const actuator::EffectKind*> kinds{&shifted.kind};
    const ScreeningRequest request{.kinds = kinds, .scale = rig_scale(shifted.runs, model_of(shifted.declared))};
    const auto untested = untested_kinds(shifted.runs, base, screen_effects(shifted.runs, base, request), request);
    EXPECT_EQ(untested.size(), fall < 0.1 ? 1u : 0u) << fall;
  }
}

// The mean of n readings scatters by sigma / sqrt(n), and 1.96 times that holds 95 %; roots are found to a hundredth.
TEST(ProfileLikelihood, OfALinearNumberEndsAtItsStandardDeviations) {
  const Shifted shifted;
  const FittedHypothesis fitted =
      fitted_to(shifted.runs, shifted.declared, {{.kind = &shifted.kind, .values = {0.01}}});
  EXPECT_NEAR(fitted.fit.values[0], shifted_zero, simulation_error * shifted_zero);
  const double deviation = noise_sigma / std::sqrt(static_cast<double>(readings));
  for (const double overdispersion : {1.0, 4.0}) {
    ProfileLikelihood profile(shifted.runs, fitted, 0, overdispersion);
    const double reach = normal_95 * std::sqrt(overdispersion) * deviation;
    EXPECT_NEAR(profile.crossing(1.0, deviation) - fitted.fit.values[0], reach, 0.02 * reach);
    EXPECT_NEAR(fitted.fit.values[0] - profile.crossing(-1.0, deviation), reach, 0.02 * reach);
  }
}

}  // namespace
}  // namespace coilwright::measurement::identification
