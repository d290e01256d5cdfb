#include "coilwright/measurement/identification/verdict.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::EffectKind;

const EffectKind* kind(std::string_view id) {
  return actuator::standard_effects().find(id);
}
const EffectKind* const friction = kind("dry_friction");
const EffectKind* const loop = kind("hysteresis");
const EffectKind* const drag = kind("quadratic_drag");

WeighedHypothesis with(std::vector<const EffectKind*> effects, double probability, double of_noise = 1.0) {
  const double left = 100.0 / (1.0 + static_cast<double>(effects.size()));
  return {
      .effects = std::move(effects), .chi_square = left, .probability = probability, .probability_of_noise = of_noise};
}

// Of 10,000 values; what was left out of it moved so much, over the noise.
WeighedHypothesis without_much(double moved, std::vector<const EffectKind*> effects, double probability) {
  return {.effects = std::move(effects),
          .chi_square = 10000.0 * (1.0 + moved * moved),
          .probability = probability,
          .probability_of_noise = 0.5,
          .probability_of_declared = 0.01};
}

WeighedHypothesis at_the_noise(std::vector<const EffectKind*> effects) {
  return without_much(0.0, std::move(effects), 1.0);
}

std::vector<const EffectKind*> reported(const Posterior& posterior) {
  return posterior.hypotheses[answer_of(posterior).reported].effects;
}

// A false name costs ten times a missed one: no effect may be there with at most 1 / 11.
TEST(Answer, NamesAnEffectWhoseAbsenceIsImprobableEnough) {
  EXPECT_EQ(reported({.hypotheses = {with({drag}, 0.91), with({}, 0.09)}}), std::vector{drag});
  EXPECT_TRUE(reported({.hypotheses = {with({drag}, 0.90), with({}, 0.10)}}).empty());
  EXPECT_EQ(answer_of({.hypotheses = {with({drag}, 0.70), with({}, 0.30)}}, {.false_name = 2.0}).reported, 0u);
}

TEST(Answer, LeavesOutWhatTheOthersExplainWithoutIt) {
  EXPECT_EQ(reported({.hypotheses = {with({drag, loop}, 0.80), with({drag}, 0.19), with({}, 0.01)}}),
            std::vector{drag});
  EXPECT_EQ(reported({.hypotheses = {with({drag, loop}, 0.95), with({drag}, 0.04), with({}, 0.01)}}),
            (std::vector{drag, loop}));
}

// Something is missing for certain, and the records do not tell which of two: one is named, with the other beside it.
TEST(Answer, StatesWhatMayBeThereInThePlaceOfAnEffect) {
  const Posterior posterior{
      .hypotheses = {with({friction}, 0.60), with({loop}, 0.36), with({drag}, 0.03), with({}, 0.01)}};
  const Answer answer = answer_of(posterior);
  EXPECT_EQ(answer.reported, 0u);
  EXPECT_EQ(answer.rivals, std::vector<std::size_t>{1});  // both hold 96 %
  EXPECT_EQ(answer.indistinguishable, (std::vector<std::vector<const EffectKind*>>{{friction, loop}}));
}

// Without the friction it is the loop, whatever else is there with it.
TEST(Answer, StatesNothingThatOnlyAccompaniesAnother) {
  const Posterior posterior{.hypotheses = {with({friction}, 0.64), with({loop}, 0.24), with({loop, drag}, 0.06),
                                           with({loop, kind("force_gain")}, 0.05), with({}, 0.01)}};
  const Answer answer = answer_of(posterior);
  EXPECT_EQ(answer.indistinguishable, (std::vector<std::vector<const EffectKind*>>{{friction, loop}}));
  EXPECT_DOUBLE_EQ(posterior.probability_of_any(answer.indistinguishable.front()), 0.99);
  EXPECT_EQ(answer.rivals, std::vector<std::size_t>{1});  // of three that hold 95 % with the first
}

// Twice the noise is left, of which the drag takes away 4 %.
TEST(Answer, LeavesOutWhatTakesAwayNextToNothingOfWhatIsNoNoise) {
  const auto leaving = [](std::vector<const EffectKind*> effects, double probability, double chi_square) {
    return WeighedHypothesis{.effects = std::move(effects), .chi_square = chi_square, .probability = probability};
  };
  EXPECT_EQ(reported({.hypotheses = {leaving({friction, drag}, 0.99, 3840.0), leaving({friction}, 0.01, 4000.0),
                                     leaving({}, 0.0, 9000.0)}}),
            std::vector{friction});
  EXPECT_EQ(reported({.hypotheses = {leaving({friction, drag}, 0.99, 3760.0), leaving({friction}, 0.01, 4000.0),
                                     leaving({}, 0.0, 9000.0)}}),
            (std::vector{friction, drag}));
}

TEST(Answer, TakesAnEffectWithFurtherNumbersForTheSame) {
  const EffectKind* further = friction->with_further_numbers();
  ASSERT_NE(further, nullptr);
  const Posterior posterior{.hypotheses = {with({friction}, 0.55), with({further}, 0.43), with({}, 0.02)}};
  const Answer answer = answer_of(posterior);
  EXPECT_EQ(answer.reported, 0u);
  EXPECT_TRUE(answer.rivals.empty());
}

// However certain: a thousandth of an angle that a stop leaves at rest is no scale that is off.
TEST(Answer, LeavesOutWhatNobodyWouldSee) {
  EXPECT_TRUE(reported({.hypotheses = {at_the_noise({drag}), without_much(0.09, {}, 1e-9)}}).empty());
  EXPECT_EQ(reported({.hypotheses = {at_the_noise({drag, loop}), without_much(0.09, {drag}, 1e-9), with({}, 0.0)}}),
            std::vector{drag});
  EXPECT_EQ(reported({.hypotheses = {at_the_noise({drag, loop}), without_much(0.05, {loop}, 1e-7),
                                     without_much(0.05, {drag}, 1e-9), with({}, 0.0)}}),
            std::vector{loop});
}

// Each moves less than a tenth of the noise, both together more.
TEST(Answer, LeavesOutNoMoreThanNobodyWouldSee) {
  EXPECT_EQ(reported({.hypotheses = {at_the_noise({drag, loop}), without_much(0.08, {drag}, 1e-9),
                                     without_much(0.08, {loop}, 1e-10), without_much(0.11, {}, 1e-12)}}),
            std::vector{drag});
}

TEST(Answer, NamesWhatIsSeenThoughTheRestIsBelowTheStatedNoise) {
  EXPECT_EQ(reported({.hypotheses = {at_the_noise({drag}), without_much(0.11, {}, 1e-9)}}), std::vector{drag});
}

TEST(Answer, NamesWhatOnlyNumbersFarOffCouldReplace) {
  WeighedHypothesis none = without_much(0.09, {}, 1e-9);
  none.probability_of_declared = 0.009;
  EXPECT_EQ(reported({.hypotheses = {at_the_noise({drag}), none}}), std::vector{drag});
}

TEST(Answer, NamesWhatLeavesStructureWhereItIsMissing) {
  WeighedHypothesis none = without_much(0.09, {}, 1e-9);
  none.probability_of_noise = 0.49;
  EXPECT_EQ(reported({.hypotheses = {at_the_noise({drag}), none}}), std::vector{drag});
}

TEST(VerdictOf, FollowsFromTheEffectsAndFromWhatTheyLeave) {
  const auto verdict = [](const Posterior& posterior, bool numbers_are_off) {
    return verdict_of(posterior, answer_of(posterior), numbers_are_off);
  };
  EXPECT_EQ(verdict({.hypotheses = {with({drag}, 1.0, 0.9), with({}, 0.0)}}, false), Verdict::explained);
  EXPECT_EQ(verdict({.hypotheses = {with({drag}, 1.0, 0.2), with({}, 0.0)}}, false), Verdict::partly_explained);
  EXPECT_EQ(verdict({.hypotheses = {with({}, 1.0, 0.2)}}, true), Verdict::unexplained);
  EXPECT_EQ(verdict({.hypotheses = {with({}, 1.0, 0.9)}}, true), Verdict::declared_numbers_off);
  EXPECT_EQ(verdict({.hypotheses = {with({}, 1.0, 0.9)}}, false), Verdict::no_missing_effect);
}

}  // namespace
}  // namespace coilwright::measurement::identification
