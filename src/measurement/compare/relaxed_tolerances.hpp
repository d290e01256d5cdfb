#pragma once

#include <span>

#include "measurement/compare/fitted_hypothesis.hpp"
#include "measurement/fit/counted.hpp"

namespace coilwright::measurement::compare {

/// Whether an effect that `with` has and `without` lacks is what a change of a declared number is called
/// (CalibrationParameter::effect).
[[nodiscard]] bool adds_the_name_of_a_number(const FittedHypothesis& without, const FittedHypothesis& with);

/// The gain of the quasi-BIC of `with` over `without` where every tolerance is three times as wide, both fitted again.
/// Where declared numbers explain the data but are further off than their tolerances allow, priors pull them back, and
/// any effect that gives way to the pull seems to gain; here it must gain by what the data show.
[[nodiscard]] fit::Counted<double> gain_with_wide_tolerances(std::span<const replay::PreparedRun> runs,
                                                             const FittedHypothesis& without,
                                                             const FittedHypothesis& with, double overdispersion);

}  // namespace coilwright::measurement::compare
