#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/compare/number_off.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// Whether an effect that `with` has and `without` lacks is what a change of a declared number is called
/// (CalibrationParameter::effect).
[[nodiscard]] bool adds_the_name_of_a_number(const FittedHypothesis& without, const FittedHypothesis& with);

/// The gain of the quasi-BIC of `with` over `without` where every tolerance is three times as wide, both fitted again.
/// Where declared numbers explain the data but are further off than their tolerances allow, priors pull them back, and
/// any effect that gives way to the pull seems to gain; here it must gain by what the data show.
[[nodiscard]] double gain_with_wide_tolerances(std::span<const replay::PreparedRun> runs,
                                               const FittedHypothesis& without, const FittedHypothesis& with,
                                               double overdispersion);

/// How much a hypothesis gains over a smaller one with one declared number free.
struct GainOverFreeNumber {
  double gain = std::numeric_limits<double>::infinity();  ///< of the quasi-BIC; infinite where no number was tried
  std::string number{};  ///< its key, or the function of which it is a coefficient; empty where none was tried
};
/// The gain of `with` over `without` with that one of its declared numbers free that does most for it, charged as a
/// number of an effect is. Numbers are tried that the fit of `without` has moved by more than two tolerances, four at
/// most, and none whose name an effect of `with` is. A number of which somebody was too sure moves as far as it is off;
/// held by its prior, its error spreads to correlated parameters, and to any effect that does alike. Coefficients of
/// one function (CalibrationParameter::function) are tried together, charged once, with tolerances ten times as wide:
/// they stay those of a smooth function.
[[nodiscard]] GainOverFreeNumber gain_over_a_free_number(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& without, const FittedHypothesis& with,
                                                         double overdispersion);

/// The declared numbers, or functions, of which one is off by itself: of those that `fitted` has moved by more than a
/// tolerance (eight at most) those that gain as gain_over_a_free_number() counts it, decisively over `fitted` and by no
/// decisively less than the best (DecisionThresholds::decisive_gain); the best first. Empty where none is. Within its
/// tolerance a number gains so much in about 1 of 1000 fits (chi-square of one degree of freedom beyond 11, the charge
/// and the threshold of a record of 100 samples), or fewer.
[[nodiscard]] std::vector<NumberOff> numbers_that_may_be_off(std::span<const replay::PreparedRun> runs,
                                                             const FittedHypothesis& fitted, double overdispersion);

}  // namespace coilwright::measurement::compare
