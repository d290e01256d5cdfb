#pragma once

#include <vector>

#include "coilwright/measurement/identification/verdict.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/identification/weighed_fit.hpp"

namespace coilwright::measurement::identification {

/// The outcome of the comparison of all hypotheses.
struct Attribution {
  FittedHypothesis before;                 ///< the recalibrated declared model
  FittedHypothesis after;                  ///< the reported hypothesis; `before` where it has no effect
  std::vector<FittedHypothesis> rivals{};  ///< as Answer::rivals has them
  Posterior posterior{};
  std::vector<WeighedFit> weighed{};  ///< of its hypotheses, in their order
  Answer answer{};
  std::vector<const actuator::EffectKind*> kinds{};  ///< that were compared: those that show in these records
  actuator::RigScale scale{};                        ///< from which they derive their initial guesses

  [[nodiscard]] bool has_effects() const { return !after.hypothesis.effects().empty(); }
};

}  // namespace coilwright::measurement::identification
