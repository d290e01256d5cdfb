#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/signals/whiteness_test.hpp"
#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::identification {

/// A hypothesis, its fit to the fit runs, and whether its residual is white.
struct FittedHypothesis {
  fit::Hypothesis hypothesis;
  fit::Fit fit{};
  signals::WhitenessResult whiteness{};

  /// Chi-square minus its expectation for noise alone.
  [[nodiscard]] double chi_square_above_noise() const;
  [[nodiscard]] std::vector<const actuator::EffectKind*> kinds() const;
};

/// The probability that declared numbers with these tolerances lie at least as far from what the fit found, all
/// together. 1 where no number has a tolerance.
[[nodiscard]] double probability_of_declared_numbers(const FittedHypothesis& fitted);
/// The same of a sum of squared distances over their tolerances: chi-square with as many degrees of freedom as there
/// are tolerances.
[[nodiscard]] double probability_of_distance(const fit::Hypothesis& hypothesis, double squares);

[[nodiscard]] FittedHypothesis score(std::span<const replay::PreparedRun> runs, fit::Hypothesis hypothesis,
                                     fit::Fit fitted);

/// Overdispersion: chi-square per independent sample of the residual; 1 for white residuals at the known noise level.
/// (The c-hat of quasi-likelihood: Burnham and Anderson, Model Selection and Multimodel Inference, 2002, section 2.5.)
[[nodiscard]] double overdispersion_of(std::span<const replay::PreparedRun> runs, const FittedHypothesis& reference);

/// What each number of a hypothesis costs it in the quasi-BIC.
[[nodiscard]] double penalty_per_number(const FittedHypothesis& fitted, double overdispersion);
/// Quasi-BIC of a hypothesis, the smaller the better: chi-square over the overdispersion, plus a penalty for every
/// parameter (Schwarz 1978, with the number of independent samples).
[[nodiscard]] double quasi_bic(const FittedHypothesis& fitted, double overdispersion);

}  // namespace coilwright::measurement::identification
