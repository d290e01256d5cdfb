#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/compare/level_fits.hpp"
#include "measurement/compare/pruned_attribution.hpp"
#include "measurement/compare/rig_scale.hpp"
#include "measurement/compare/select_hypothesis.hpp"
#include "measurement/compare/slide_fits.hpp"
#include "measurement/slider_model.hpp"

// The functions that decide, each by a case that a hand can compute.
namespace coilwright::measurement::compare {
namespace {

const actuator::EffectKind& standard_kind(std::string_view id) {
  return *actuator::standard_effects().find(id);
}

// The slide and effects as a fit of 100 samples left them: white, with this chi-square.
FittedHypothesis left_with(double chi_square, const std::vector<actuator::Effect>& effects = {}) {
  static const replay::DeclaredModel declared = slide(true_mass, true_damping);
  FittedHypothesis out{.hypothesis = fit::Hypothesis(declared, effects)};
  out.fit.values = out.hypothesis.start();
  out.fit.chi_square = chi_square;
  out.fit.used_samples = 100;
  return out;
}

actuator::Effect some_drag(double strength) {
  return {.kind = &standard_kind("quadratic_drag"), .values = {strength}};
}

actuator::Effect some_loop() {
  return {.kind = &standard_kind("hysteresis"), .values = {0.01, 3.0}};
}

TEST(Overdispersion, OfAWhiteResidualIsItsMeanSquareAndNeverBelowOne) {
  EXPECT_DOUBLE_EQ(overdispersion_of({}, left_with(400.0)), 4.0);
  EXPECT_DOUBLE_EQ(overdispersion_of({}, left_with(50.0)), 1.0);
}

// Of the values 1, 1, 0, 0, .. the sum of squares is 2, that of products of neighbours 1: the correlation time is
// 1 + 2 (1/2) = 2 samples.
TEST(Overdispersion, OfAResidualWithStructureCountsItsCorrelationTime) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const data::Run run = slide_run(20, {}, no_error);
  const std::vector runs{replay::prepare_run(run, declared, model_of(declared))};
  FittedHypothesis fitted = left_with(300.0);
  fitted.whiteness.structure = 2.0;
  fitted.fit.runs.resize(1);
  fitted.fit.runs.front().residuals = Eigen::VectorXd::Zero(20);
  fitted.fit.runs.front().residuals.head(2).setOnes();
  EXPECT_NEAR(overdispersion_of(runs, fitted), 3.0 * 2.0, 1e-12);
}

// A number costs ln 100 = 4.6: the loop with two gains 26 - 9.2, the drag with one 20 - 4.6, which is less by 1.4.
TEST(SelectHypothesis, TakesTheSimplestWithinADecisiveGainOfTheBest) {
  const Selection found =
      select_hypothesis({}, left_with(100.0), {left_with(80.0, {some_drag(0.1)}), left_with(74.0, {some_loop()})}, 1.0);
  ASSERT_EQ(found.ranked.size(), 2u);
  EXPECT_EQ(found.ranked.front().effects.front()->id(), "hysteresis");
  EXPECT_NEAR(found.ranked.front().evidence->criterion_gain, 26.0 - 2.0 * std::log(100.0), 1e-12);
  ASSERT_EQ(found.steps.size(), 1u);
  EXPECT_EQ(found.steps.front().kinds().front()->id(), "quadratic_drag");
  ASSERT_EQ(found.rivals.size(), 1u);
  EXPECT_EQ(found.indistinguishable.size(), 1u);
}

TEST(SelectHypothesis, TakesNoneThatGainsLessThanSix) {
  EXPECT_TRUE(select_hypothesis({}, left_with(100.0), {left_with(89.5, {some_drag(0.1)})}, 1.0).steps.empty());
  EXPECT_EQ(select_hypothesis({}, left_with(100.0), {left_with(89.0, {some_drag(0.1)})}, 1.0).steps.size(), 1u);
}

TEST(SelectHypothesis, RulesOutWhatFitsBestWhereItIsAbsentOrNoBetter) {
  const Selection found = select_hypothesis({}, left_with(100.0),
                                            {left_with(50.0, {some_drag(0.0)}), left_with(101.0, {some_loop()})}, 1.0);
  EXPECT_TRUE(found.ranked.empty());
  ASSERT_EQ(found.ruled_out.size(), 2u);
  EXPECT_EQ(found.ruled_out[0].remark, "fits best where it is absent");
  EXPECT_EQ(found.ruled_out[1].remark, "fits no better than without it");
}

// The best explains 500 of 1000: the first two always, of the others those that explain a tenth of that.
TEST(Contenders, AreTheFirstTwoAndWhatExplainsATenthOfTheBest) {
  const HypothesesOfSize level{left_with(500.0), left_with(990.0), left_with(960.0), left_with(940.0)};
  EXPECT_EQ(contenders(level, 1000.0, 4), (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(contenders(level, 1000.0, 2), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(nearest(level), &level.front());
}

// The slide with and without a drag in its records, and the drag in the attribution.
PrunedAttribution pruned_of(double true_drag) {
  static const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const data::Run run = dragged_run(400, true_drag, 0.3 * noise_sigma, 5);
  std::vector runs{replay::prepare_run(run, declared, model_of(declared))};
  Attribution found{.steps = {fitted_to(runs, declared, {}), fitted_to(runs, declared, {some_drag(0.1)})},
                    .compared = {{.effects = {&standard_kind("quadratic_drag")}}}};
  return prune_unsupported_effects(runs, std::move(found));
}

TEST(Pruning, DropsAnEffectThatTheRecordsDoNotShow) {
  const PrunedAttribution found = pruned_of(0.0);
  EXPECT_EQ(found.attribution.steps.size(), 1u);
  EXPECT_EQ(found.attribution.compared.front().remark, "gains too little over the best fit without it");
  EXPECT_TRUE(found.evidence.empty());
}

TEST(Pruning, KeepsAnEffectThatTheyShow) {
  const PrunedAttribution found = pruned_of(1.0);
  ASSERT_EQ(found.attribution.steps.size(), 2u);
  ASSERT_EQ(found.estimates.size(), 3u);
  EXPECT_LT(found.estimates[2].lower, 1.0);
  EXPECT_GT(found.estimates[2].upper, 1.0);
}

}  // namespace
}  // namespace coilwright::measurement::compare
