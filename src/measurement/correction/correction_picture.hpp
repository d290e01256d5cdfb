#pragma once

#include <span>

#include "coilwright/measurement/correction/nameless_correction.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"
#include "measurement/correction/correction_kind.hpp"

namespace coilwright::measurement::correction {

/// A correction that was fitted beside the model without it.
struct FittedCorrection {
  const compare::FittedHypothesis& base;
  const compare::FittedHypothesis& corrected;  ///< its last effect is of `kind`
  const CorrectionKind& kind;
  std::span<const JointSample> samples{};  ///< where the joints were
  double cross_validated_gain{};
};

/// What it tells the person who will name it.
[[nodiscard]] NamelessCorrection described(const FittedCorrection& found);

}  // namespace coilwright::measurement::correction
