#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "coilwright/measurement/identification/posterior.hpp"

namespace coilwright::measurement::identification {

/// The conclusion of a diagnosis; docs/theory/measurement.md states the rule for each.
enum class Verdict {
  no_missing_effect,     ///< the recalibrated declared model already leaves noise
  declared_numbers_off,  ///< declared numbers leave noise, moved further than their tolerances make likely (1 in 100),
                         ///< or one by itself is off (Diagnosis::numbers_off)
  explained,             ///< with the effects the residual is noise
  partly_explained,      ///< effects are there, and structure remains
  unexplained,           ///< structure remains, and the data support no effect
  incomplete             ///< there is no conclusion: the diagnosis was interrupted
};

/// "partly_explained".
[[nodiscard]] std::string_view name_of(Verdict verdict);

/// What a wrong statement costs, over what it costs to say nothing where it would have been right. A statement is made
/// where its expected cost is the smaller one: above the probability cost / (1 + cost).
struct Losses {
  double false_name = 10.0;  ///< an effect that is not there is named
  double false_noise = 1.0;  ///< structure is called noise
};

/// What a posterior is reported as. Refers to hypotheses by their place in it.
struct Answer {
  std::size_t reported{};  ///< the hypothesis whose effects are named
  std::vector<std::size_t>
      rivals{};  ///< of the most probable that hold 95 % together, those without one of its effects
  /// For each reported effect that has them, it and then the effects that may be there in its place: of the hypotheses
  /// with none of those before, each is in the most, by probability, and in 5 % of all at least.
  std::vector<std::vector<const actuator::EffectKind*>> indistinguishable{};
  bool leaves_noise{};  ///< whether what the reported hypothesis leaves is called noise
};

/// The most probable hypothesis of which no effect may be left out: one whose place could stay empty with more than
/// 1 / (1 + false_name), by all hypotheses that have no more than the others, is not named. Nor is one, however
/// certain, that changes nothing anyone would see (DecisionThresholds::least_over_noise): the most probable of the
/// others leaves hardly more variance than the most probable of all, it is noise, and its declared numbers are credible
/// (DecisionThresholds::least_probability). Where the most probable of all leaves more than noise, neither is one named
/// that takes away less than DecisionThresholds::least_share of what the others leave. `posterior` has at least the
/// hypothesis of no effect.
[[nodiscard]] Answer answer_of(const Posterior& posterior, const Losses& losses = {});

/// The verdict of an answer. `numbers_are_off`: whether declared numbers of the model without effects are.
[[nodiscard]] Verdict verdict_of(const Posterior& posterior, const Answer& answer, bool numbers_are_off);

}  // namespace coilwright::measurement::identification
