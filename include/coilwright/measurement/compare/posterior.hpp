#pragma once

#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::measurement::compare {

/// One hypothesis and how probable it is.
struct WeighedHypothesis {
  std::vector<const actuator::EffectKind*> effects{};  ///< empty: the declared model, recalibrated
  double log_evidence{};                               ///< natural logarithm, over that of no effect
  double probability{};                                ///< among all that were fitted
};

/// What the records and the priors say of every hypothesis that was fitted. A hypothesis that was not fitted counts as
/// impossible, and what no effect of the catalogue does is no hypothesis: the probabilities hold given that the truth
/// is among the hypotheses.
struct Posterior {
  std::vector<WeighedHypothesis> hypotheses{};  ///< most probable first; the probabilities add up to 1

  /// An effect, and the probability that it is there.
  struct Inclusion {
    std::string_view effect{};  ///< its id
    double probability{};       ///< of all hypotheses with it, whatever its further numbers
  };
  /// Every effect of a hypothesis, the most probable first.
  [[nodiscard]] std::vector<Inclusion> effects() const;
  /// The probability that an effect is there; 0 where no hypothesis has it.
  [[nodiscard]] double probability_of(std::string_view effect) const;
  /// Of just these effects together, in any order.
  [[nodiscard]] double probability_of(const std::vector<const actuator::EffectKind*>& effects) const;
};

}  // namespace coilwright::measurement::compare
