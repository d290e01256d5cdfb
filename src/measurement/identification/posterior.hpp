#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/measurement/identification/posterior.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/identification/weighed_fit.hpp"

namespace coilwright::measurement::identification {

/// The natural logarithm of the prior probability of a hypothesis whose effects are among `kinds`: one half for none,
/// half as much for each effect more, shared among all hypotheses of a size (Scott and Berger, Ann. Stat. 38 (2010)
/// 2587). An effect shares its part with itself with further numbers (EffectKind::with_further_numbers). A belief
/// multiplies the odds of all hypotheses with its effect: by its own over those of one effect of `kinds`, whose prior
/// probability is one over their number.
[[nodiscard]] double log_prior(const std::vector<const actuator::EffectKind*>& effects,
                               const std::vector<const actuator::EffectKind*>& kinds,
                               std::span<const Belief> beliefs = {});

/// How much of the logarithm of the evidence counts: all of it where the heaviest hypothesis leaves noise, see
/// posterior_of().
[[nodiscard]] double share_of_evidence(const WeighedFit& heaviest);

/// Hypotheses with what was found of each.
struct WeighedHypotheses {
  Posterior posterior{};
  std::vector<WeighedFit> weighed{};  ///< of each hypothesis of the posterior
  std::vector<std::size_t> fits{};    ///< which of the fits it is: 0 is that without effects
};

/// `declared` and `fitted`, all fitted to `runs`, with their probabilities (weighed()). Of several fits of one
/// hypothesis the best counts. Where the most probable lacks something, no hypothesis is true, and the evidence of each
/// is raised to a power below 1: as if the records told as much of what is missing as 30 independent values of it
/// (Miller and Dunson, J. Am. Stat. Assoc. 114 (2019) 1113: coarsening).
[[nodiscard]] WeighedHypotheses posterior_of(std::span<const replay::PreparedRun> runs,
                                             const FittedHypothesis& declared,
                                             const std::vector<FittedHypothesis>& fitted,
                                             const std::vector<const actuator::EffectKind*>& kinds,
                                             const actuator::RigScale& scale, std::span<const Belief> beliefs = {});

/// A hypothesis as a short fit shows it.
struct FirstImpression {
  std::vector<const actuator::EffectKind*> effects{};
  double chi_square{};
  double criterion{};  ///< quasi_bic()
};

/// What is known of hypotheses before the search has ended: their evidence by Schwarz's approximation, minus half of
/// the quasi-BIC (Schwarz, Ann. Stat. 6 (1978) 461), with the overdispersion of `declared`, the model without effects;
/// unknown (NaN) as long as there is no other.
[[nodiscard]] Posterior first_impressions(const FittedHypothesis& declared, const std::vector<FirstImpression>& fits,
                                          const std::vector<const actuator::EffectKind*>& kinds,
                                          std::span<const Belief> beliefs, double overdispersion);

}  // namespace coilwright::measurement::identification
