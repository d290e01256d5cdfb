#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/identification/number_off.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// The declared numbers, or functions, of which one is off by itself: of those that `fitted` has moved by more than a
/// tolerance (eight at most) those that, free, gain decisively over `fitted` and by no decisively less than the best
/// (DecisionThresholds::decisive_gain), charged as a number of an effect is; the best first. Coefficients of one
/// function (CalibrationParameter::function) are tried together, charged once, with tolerances ten times as wide: they
/// stay those of a smooth function. Empty where none is. Within its
/// tolerance a number gains so much in about 1 of 1000 fits (chi-square of one degree of freedom beyond 11, the charge
/// and the threshold of a record of 100 samples), or fewer.
[[nodiscard]] std::vector<NumberOff> numbers_that_may_be_off(std::span<const replay::PreparedRun> runs,
                                                             const FittedHypothesis& fitted, double overdispersion);

}  // namespace coilwright::measurement::identification
