#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

struct CrossValidation {
  double gain = std::numeric_limits<double>::quiet_NaN();  ///< see Evidence::cross_validated_gain
  std::vector<std::size_t> unpredictable_runs{};           ///< their indices, in order; see cross_validated
};

/// How much better `with` predicts runs to which it was not fitted than `without`: each fit run is left out in turn (by
/// one Gauss-Newton step from the fit to all runs where that does what it promises, otherwise by a fit of the others),
/// and the gain is the fraction of the squared residual above the noise that `with` removes.
///
/// A run of which the others cannot tell what it shows is not counted: where what they leave open of the numbers of
/// `with` makes more of its squared residual than the effect takes away in it, and more than its noise scatters by.
/// Heat shows in the one long hold, and steps leave its time constant anywhere; what they predict of the hold is no
/// evidence against heat. `overdispersion` as in quasi_bic. NaN where no run is left to count, and for a single run.
[[nodiscard]] CrossValidation cross_validated(std::span<const replay::PreparedRun> runs,
                                              const FittedHypothesis& without, const FittedHypothesis& with,
                                              double overdispersion);

}  // namespace coilwright::measurement::compare
