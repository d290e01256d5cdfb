#pragma once

#include <span>
#include <vector>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::correction {

/// For each run the sum of its squared residuals at parameters that were fitted without it: runs are left out in turn,
/// in at most five groups, and the others fitted anew from `fitted` in a few steps. Infinite where that cannot be
/// simulated.
[[nodiscard]] std::vector<double> held_out_squares(std::span<const replay::PreparedRun> runs,
                                                   const identification::FittedHypothesis& fitted);

/// Mean over all motions of the share of the squared residual above the noise that `with` takes away from `without`;
/// where it adds some, minus the share of its own. Each of the motions counts the same, from -1 to 1: a long one is no
/// better example of one to come than a short one.
[[nodiscard]] double mean_gain(std::span<const replay::PreparedRun> runs, const std::vector<double>& without,
                               const std::vector<double>& with);

}  // namespace coilwright::measurement::correction
