#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::measurement::identification {

/// One hypothesis and how probable it is.
struct WeighedHypothesis {
  std::vector<const actuator::EffectKind*> effects{};  ///< empty: the declared model, recalibrated
  double chi_square{};                                 ///< sum of squared residuals of the fit runs over their noise
  double log_evidence{};                               ///< natural logarithm, over that of no effect
  /// Among all that were fitted. Where the most probable lacks something, evidence counts for less than its size.
  double probability{};
  /// What it lacks, most probably: standard deviation over that of the noise, and correlation length in samples.
  double lacks{}, lacks_over{};
  double probability_of_noise{};  ///< that it lacks less than a tenth of the noise
  /// Of rigs built to their tolerances, the share whose numbers lie as far from the declared ones as its own do.
  double probability_of_declared{};
  /// Whether its fit is shown to be at an optimum: the fall of the objective that it still promises decides nothing.
  /// Otherwise its evidence is a lower bound.
  bool at_optimum = true;
};

/// A hypothesis that has no probability, and why.
struct RuledOut {
  std::vector<const actuator::EffectKind*> effects{};
  std::string remark{};  ///< "does not fit this rig: ..."
};

/// RuledOut::remark of an effect that would change nothing in these records, however strong it plausibly is.
inline constexpr std::string_view not_tested_remark =
    "is not tested: at any plausible strength these records would be the same; as probable as before";

/// What the records and the priors say of every hypothesis that was fitted. A hypothesis that was not fitted counts as
/// impossible, and what no effect of the catalogue does is no hypothesis: the probabilities hold given that the truth
/// is among the hypotheses. Whether it may be is what `probability_of_noise` says.
struct Posterior {
  std::vector<WeighedHypothesis> hypotheses{};  ///< most probable first; the probabilities add up to 1
  std::vector<RuledOut> ruled_out{};

  /// An effect, and the probability that it is there.
  struct Inclusion {
    std::string_view effect{};  ///< its id
    double probability{};       ///< of all hypotheses with it, whatever its further numbers
  };
  /// Every effect of a hypothesis, the most probable first.
  [[nodiscard]] std::vector<Inclusion> effects() const;
  /// Those of `ruled_out` with not_tested_remark.
  [[nodiscard]] std::vector<const actuator::EffectKind*> not_tested() const;
  /// The probability of just these effects together, in any order, whatever their further numbers.
  [[nodiscard]] double probability_of(const std::vector<const actuator::EffectKind*>& effects) const;
  /// The probability that at least one of these effects is there.
  [[nodiscard]] double probability_of_any(const std::vector<const actuator::EffectKind*>& effects) const;
  /// The probability of all hypotheses that have none but these effects.
  [[nodiscard]] double probability_among(const std::vector<const actuator::EffectKind*>& effects) const;
};

/// What somebody who knows the rig believes of an effect before the records are seen ("the wire drags").
struct Belief {
  std::string effect{};  ///< its id
  double probability{};  ///< that it is there; above 0, below 1
};

/// Whether each of `some` is among `of`; an effect with further numbers is the same effect.
[[nodiscard]] bool are_among(const std::vector<const actuator::EffectKind*>& some,
                             const std::vector<const actuator::EffectKind*>& of);

/// The ids of effects, sorted: an effect with further numbers is the same effect.
[[nodiscard]] std::vector<std::string_view> ids_of(const std::vector<const actuator::EffectKind*>& effects);

}  // namespace coilwright::measurement::identification
