#include "measurement/compare/posterior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/compare/rig_scale.hpp"
#include "measurement/compare/slide_fits.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::EffectKind;

const EffectKind& catalogued(std::string_view id) {
  return *actuator::standard_effects().find(id);
}

// The integral of f from `low` to `high` by the trapezium rule.
template <typename Function>
double integral(const Function& f, double low, double high) {
  constexpr int steps = 20000;
  const double width = (high - low) / steps;
  double sum = 0.5 * (f(low) + f(high));
  for (int i = 1; i < steps; ++i) sum += f(low + i * width);
  return sum * width;
}

// A log-normal magnitude of a typical degree, on both sides of zero: written out anew.
double density_of_zero(double offset) {
  const double spread = std::log(10.0);
  const double u = std::log(std::abs(offset) / (std::numbers::pi / 180.0)) / spread;
  return 0.5 * std::exp(-0.5 * u * u) / (std::sqrt(2.0 * std::numbers::pi) * spread * std::abs(offset));
}

TEST(LogEvidence, OfALinearNumberIsTheIntegralOfItsLikelihoodOverItsPrior) {
  constexpr std::size_t readings = 100;
  constexpr double shift = 0.0005;  // rad, five standard deviations of the mean
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  declared.calibration.clear();
  declared.build = [](std::span<const double> /*values*/) {
    return slide(true_mass, true_damping).build(std::vector{true_mass, true_damping});
  };
  const data::Run run = slide_run(readings, {}, [] { return shift; });
  const std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, model_of(declared))};
  const actuator::RigScale scale = rig_scale(runs, model_of(declared));
  const FittedHypothesis with = fitted_to(runs, declared, {{.kind = &catalogued("angle_offset"), .values = {0.01}}});
  for (const double overdispersion : {1.0, 4.0}) {
    const double deviation = std::sqrt(overdispersion / readings) * noise_sigma;
    const double at = with.fit.values[0];
    const double evidence = integral(
        [&](double offset) {
          return density_of_zero(offset) * std::exp(-0.5 * std::pow((offset - at) / deviation, 2));
        },
        0.05 * at, at + 10.0 * deviation);
    // What Laplace's approximation leaves out: the prior is not constant over a fifth of the number.
    EXPECT_NEAR(log_evidence(with, scale, overdispersion) + 0.5 * with.fit.objective() / overdispersion,
                std::log(evidence), 0.1);
  }
}

TEST(LogPrior, AddsUpToOneOverAllHypotheses) {
  const std::vector<const EffectKind*> kinds{&catalogued("hysteresis"), &catalogued("quadratic_drag"),
                                             &catalogued("force_gain"), &catalogued("angle_offset")};
  double sum = 0.0;
  for (unsigned set = 0; set < 16; ++set) {
    std::vector<const EffectKind*> effects;
    for (unsigned i = 0; i < 4; ++i)
      if ((set >> i) % 2 == 1) effects.push_back(kinds[i]);
    sum += std::exp(log_prior(effects, kinds));
  }
  EXPECT_NEAR(sum, 1.0 - std::pow(0.5, 5), 1e-12);  // the rest is of five effects and more
}

TEST(LogPrior, SharesAnEffectWithItselfWithFurtherNumbers) {
  const EffectKind& friction = catalogued("dry_friction");
  const EffectKind* further = friction.with_further_numbers();
  ASSERT_NE(further, nullptr);
  const std::vector<const EffectKind*> kinds{&friction, &catalogued("hysteresis")};
  EXPECT_NEAR(std::exp(log_prior({&friction}, kinds)) + std::exp(log_prior({further}, kinds)),
              std::exp(log_prior({kinds[1]}, kinds)), 1e-12);
}

TEST(Posterior, AddsUpWhatHypothesesShare) {
  const EffectKind& drag = catalogued("quadratic_drag");
  const EffectKind& loop = catalogued("hysteresis");
  const Posterior odds{.hypotheses = {{.effects = {&drag}, .probability = 0.6},
                                      {.effects = {&drag, &loop}, .probability = 0.3},
                                      {.effects = {}, .probability = 0.1}}};
  EXPECT_DOUBLE_EQ(odds.probability_of("quadratic_drag"), 0.9);
  EXPECT_DOUBLE_EQ(odds.probability_of("hysteresis"), 0.3);
  EXPECT_DOUBLE_EQ(odds.probability_of("base_tilt"), 0.0);
  EXPECT_DOUBLE_EQ(odds.probability_of(std::vector{&loop, &drag}), 0.3);
  EXPECT_DOUBLE_EQ(odds.probability_of(std::vector<const EffectKind*>()), 0.1);
  ASSERT_EQ(odds.effects().size(), 2u);
  EXPECT_EQ(odds.effects()[0].effect, "quadratic_drag");
}

// Two fits that leave the same: what has one number more is less probable by its prior and by what the data knew.
TEST(PosteriorOf, NormalisesAndPutsTheLikeliestFirst) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const data::Run run = slide_run(100, {}, [] { return 0.02; });
  const std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, model_of(declared))};
  const actuator::RigScale scale = rig_scale(runs, model_of(declared));
  const std::vector<const EffectKind*> kinds{&catalogued("angle_offset"), &catalogued("quadratic_drag")};
  const FittedHypothesis none = fitted_to(runs, declared, {});
  const FittedHypothesis zero = fitted_to(runs, declared, {{.kind = kinds[0], .values = {0.01}}});
  const Posterior odds = posterior_of(none, {zero, zero}, kinds, scale, 1.0);
  ASSERT_EQ(odds.hypotheses.size(), 2u);  // the same twice counts once
  EXPECT_NEAR(odds.hypotheses[0].probability + odds.hypotheses[1].probability, 1.0, 1e-12);
  EXPECT_GT(odds.probability_of("angle_offset"), 0.999);
  const double ratio =
      std::log(odds.probability_of(std::vector<const EffectKind*>()) / odds.probability_of("angle_offset"));
  EXPECT_NEAR(ratio,
              log_evidence(none, scale, 1.0) - log_evidence(zero, scale, 1.0) + log_prior({}, kinds) -
                  log_prior({kinds[0]}, kinds),
              1e-9 * std::abs(ratio) + 1e-9);
}

}  // namespace
}  // namespace coilwright::measurement::compare
