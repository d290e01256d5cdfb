#include "measurement/identification/hypothesis_table.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/slide_fits.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::EffectKind;

const EffectKind& catalogued(std::string_view id) {
  return *actuator::standard_effects().find(id);
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

// Of all hypotheses up to two of three effects: what is believed of one multiplies the odds of those with it.
TEST(LogPrior, HasWhatIsBelievedOfAnEffect) {
  const EffectKind* loop = &catalogued("hysteresis");
  const std::vector<const EffectKind*> kinds{loop, &catalogued("quadratic_drag"), &catalogued("force_gain")};
  const std::vector<Belief> beliefs{{.effect = "hysteresis", .probability = 0.9}};
  // One in three without a belief: odds of a half, and of nine with it.
  EXPECT_NEAR(log_prior({loop}, kinds, beliefs) - log_prior({loop}, kinds), std::log(9.0 / 0.5), 1e-12);
  EXPECT_EQ(log_prior({kinds[1]}, kinds, beliefs), log_prior({kinds[1]}, kinds));
}

TEST(Posterior, AddsUpWhatHypothesesShare) {
  const EffectKind& drag = catalogued("quadratic_drag");
  const EffectKind& loop = catalogued("hysteresis");
  const Posterior odds{.hypotheses = {{.effects = {&drag}, .probability = 0.6},
                                      {.effects = {&drag, &loop}, .probability = 0.3},
                                      {.effects = {}, .probability = 0.1}}};
  EXPECT_DOUBLE_EQ(odds.probability_of(std::vector{&loop, &drag}), 0.3);
  EXPECT_DOUBLE_EQ(odds.probability_of(std::vector<const EffectKind*>()), 0.1);
  ASSERT_EQ(odds.effects().size(), 2u);
  EXPECT_EQ(odds.effects()[0].effect, "quadratic_drag");
  EXPECT_DOUBLE_EQ(odds.effects()[0].probability, 0.9);
  EXPECT_DOUBLE_EQ(odds.effects()[1].probability, 0.3);
}

// Two fits that leave the same: what has one number more is less probable by its prior and by what the data knew.
TEST(HypothesisTable, NormalisesAndPutsTheLikeliestFirst) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const data::Run run = slide_run(100, {}, [] { return 0.02; });
  const std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, model_of(declared))};
  const actuator::RigScale scale = rig_scale(runs, model_of(declared));
  const std::vector<const EffectKind*> kinds{&catalogued("angle_offset"), &catalogued("quadratic_drag")};
  const FittedHypothesis none = fitted_to(runs, declared, {});
  const FittedHypothesis zero = fitted_to(runs, declared, {{.kind = kinds[0], .values = {0.01}}});
  HypothesisTable table({.runs = runs, .kinds = kinds, .scale = scale});
  table.add({none, zero, zero}, true);
  const WeighedHypotheses all = table.posterior();
  const std::vector<WeighedHypothesis>& odds = all.posterior.hypotheses;
  ASSERT_EQ(odds.size(), 2u);  // the same twice counts once
  EXPECT_NEAR(odds[0].probability + odds[1].probability, 1.0, 1e-12);
  ASSERT_EQ(odds[0].effects, std::vector{kinds[0]});
  EXPECT_EQ(all.fits[0]->kinds(), odds[0].effects);
  EXPECT_NEAR(
      std::log(odds[1].probability / odds[0].probability),
      all.weighed[1].log_evidence - all.weighed[0].log_evidence + log_prior({}, kinds) - log_prior({kinds[0]}, kinds),
      1e-9);
}

// A wave of three times the noise that no hypothesis has: 800 samples tell more than 60 values of it, and count for 30.
TEST(HypothesisTable, CountsThirtyValuesOfWhatEveryHypothesisLacks) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  int sample = 0;
  const data::Run run = slide_run(800, {}, [&] { return 3.0 * noise_sigma * std::sin(0.3 * sample++); });
  const std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, model_of(declared))};
  const actuator::RigScale scale = rig_scale(runs, model_of(declared));
  const std::vector<const EffectKind*> kinds{&catalogued("angle_offset"), &catalogued("quadratic_drag")};
  const FittedHypothesis none = fitted_to(runs, declared, {});
  const FittedHypothesis zero = fitted_to(runs, declared, {{.kind = kinds[0], .values = {0.01}}});
  HypothesisTable table({.runs = runs, .kinds = kinds, .scale = scale});
  table.add({none, zero}, true);
  const WeighedHypotheses all = table.posterior();
  const std::vector<WeighedHypothesis>& odds = all.posterior.hypotheses;
  ASSERT_EQ(odds.size(), 2u);
  ASSERT_LT(odds[0].probability_of_noise, 0.01);
  Eigen::MatrixXd missing(800, 800);
  for (Eigen::Index i = 0; i < 800; ++i)
    for (Eigen::Index k = 0; k < 800; ++k) {
      const double w = std::sqrt(3.0) * std::abs(static_cast<double>(i - k)) / odds[0].lacks_over;
      missing(i, k) = odds[0].lacks * odds[0].lacks * (1.0 + w) * std::exp(-w);
    }
  const double values = 800.0 - (missing + Eigen::MatrixXd::Identity(800, 800)).inverse().trace();
  ASSERT_GT(values, 60.0);
  const double prior = log_prior(odds[0].effects, kinds) - log_prior(odds[1].effects, kinds);
  EXPECT_NEAR(std::log(odds[0].probability / odds[1].probability),
              30.0 / values * (odds[0].log_evidence - odds[1].log_evidence) + prior, 1e-9);
}

}  // namespace
}  // namespace coilwright::measurement::identification
