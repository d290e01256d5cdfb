#pragma once

#include <span>

#include "coilwright/measurement/correction/nameless_correction.hpp"
#include "measurement/correction/correction_kind.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::correction {

/// A correction that was fitted beside the model without it.
struct FittedCorrection {
  const identification::FittedHypothesis& base;
  const identification::FittedHypothesis& corrected;  ///< its last effect is of `kind`
  const CorrectionKind& kind;
  std::span<const JointSample> samples{};  ///< where the joints were
  double cross_validated_gain{};
};

/// What it tells the person who will name it.
[[nodiscard]] NamelessCorrection described(const FittedCorrection& found);

}  // namespace coilwright::measurement::correction
