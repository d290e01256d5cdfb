#pragma once

#include <span>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// How much better `with` predicts runs to which it was not fitted than `without`: each fit run is left out in turn (by
/// one Gauss-Newton step from the fit to all runs where that does what it promises, otherwise by a fit of the others),
/// and the value is the fraction of the squared residual above the
/// noise that `with` removes. NaN for a single run.
[[nodiscard]] fit::Counted<double> cross_validated_gain(std::span<const replay::PreparedRun> runs,
                                                        const FittedHypothesis& without, const FittedHypothesis& with);

}  // namespace coilwright::measurement::compare
