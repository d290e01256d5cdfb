#pragma once

#include <vector>

#include "coilwright/measurement/compare/evidence.hpp"
#include "coilwright/measurement/compare/posterior.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// The outcome of the comparison of all hypotheses.
struct Attribution {
  std::vector<FittedHypothesis> steps{};   ///< the recalibrated declared model, then one more effect at each step
  std::vector<FittedHypothesis> rivals{};  ///< other hypotheses that these data cannot separate from the last step
  /// One set per effect of the last step that has rivals: the effect first, then those that could replace it.
  std::vector<std::vector<const actuator::EffectKind*>> indistinguishable{};
  std::vector<ComparedHypothesis> compared{};        ///< best first
  Posterior posterior{};                             ///< of all hypotheses that were fitted
  std::vector<const actuator::EffectKind*> kinds{};  ///< that were compared: those that fit this rig
  actuator::RigScale scale{};                        ///< from which they derive their initial guesses
  double overdispersion{1.0};                        ///< of the residual of the best hypothesis; 1 for white noise
  [[nodiscard]] const FittedHypothesis& before() const { return steps.front(); }
  [[nodiscard]] const FittedHypothesis& after() const { return steps.back(); }
};

}  // namespace coilwright::measurement::compare
