#pragma once

#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/measurement/compare/posterior.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// The natural logarithm of the prior density of an effect's numbers at `values`, and what a Laplace approximation
/// needs of it. Every number has a coordinate u in which its prior is simple; `slopes` are dphi/du, `precisions` those
/// of the prior of u. Choices are not among them.
///
/// A magnitude (its distance from the value at which the effect is absent) is log-normal about the geometric mean of
/// the catalogue's starts for this rig, with a standard deviation of a factor of 10; where either sign is physical,
/// half of that on each side. A shape between two bounds is uniform, one above zero log-normal like a magnitude, a
/// coefficient with a deviation of its own normal.
struct PriorOfNumbers {
  double log_density{};  ///< of u, and of the choices that were made
  std::vector<double> slopes{};
  std::vector<double> precisions{};
};
[[nodiscard]] PriorOfNumbers prior_of_numbers(const actuator::Effect& effect, const actuator::RigScale& scale);

/// The natural logarithm of the evidence of a hypothesis by Laplace's approximation at its fit, up to a constant that
/// is the same for all hypotheses of one declared model fitted to the same runs: the chi-squares of measurement and
/// priors over the overdispersion, the priors of its effects' numbers, and the volume that the data leave to all
/// numbers. Local numbers count through the normal equations, from which they are eliminated; that their own volume
/// differs between hypotheses is neglected. One mode. (Kass and Raftery, J. Am. Stat. Assoc. 90 (1995) 773, section
/// 4.1.)
[[nodiscard]] double log_evidence(const FittedHypothesis& fitted, const actuator::RigScale& scale,
                                  double overdispersion);

/// The natural logarithm of the prior probability of a hypothesis whose effects are among `kinds`: one half for none,
/// half as much for each effect more, shared among all hypotheses of a size (Scott and Berger, Ann. Stat. 38 (2010)
/// 2587). An effect shares its part with itself with further numbers (EffectKind::with_further_numbers).
[[nodiscard]] double log_prior(const std::vector<const actuator::EffectKind*>& effects,
                               const std::vector<const actuator::EffectKind*>& kinds);

/// `declared` and `fitted`, all fitted to the same runs, with their probabilities. Of several fits of one hypothesis
/// the best counts.
[[nodiscard]] Posterior posterior_of(const FittedHypothesis& declared, const std::vector<FittedHypothesis>& fitted,
                                     const std::vector<const actuator::EffectKind*>& kinds,
                                     const actuator::RigScale& scale, double overdispersion);

}  // namespace coilwright::measurement::compare
