#include "measurement/identification/fitted_hypothesis.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "coilwright/measurement/signals/correlation_time.hpp"

namespace coilwright::measurement::identification {

double FittedHypothesis::chi_square_above_noise() const {
  return fit.chi_square - static_cast<double>(fit.samples());
}

std::vector<const actuator::EffectKind*> FittedHypothesis::kinds() const {
  std::vector<const actuator::EffectKind*> out;
  for (const actuator::Effect& effect : hypothesis.effects()) out.push_back(effect.kind);
  return out;
}

double probability_of_declared_numbers(const FittedHypothesis& fitted) {
  return probability_of_distance(fitted.hypothesis, fitted.fit.prior_chi_square);
}

double probability_of_distance(const fit::Hypothesis& hypothesis, double squares) {
  const auto count = std::ranges::count_if(hypothesis.parameters(), &fit::FitParameter::has_prior);
  if (count == 0) return 1.0;
  const boost::math::chi_squared_distribution<double> distribution(static_cast<double>(count));
  return boost::math::cdf(boost::math::complement(distribution, squares));
}

FittedHypothesis score(std::span<const replay::PreparedRun> runs, fit::Hypothesis hypothesis, fit::Fit fitted) {
  const signals::WhitenessResult result =
      signals::whiteness_test(fit::scaled_residuals(runs, fitted), static_cast<int>(hypothesis.size()));
  return {.hypothesis = std::move(hypothesis), .fit = std::move(fitted), .whiteness = result};
}

double overdispersion_of(std::span<const replay::PreparedRun> runs, const FittedHypothesis& reference) {
  const double mean_square = reference.fit.chi_square / static_cast<double>(reference.fit.samples());
  // A residual that is noise has a correlation time of one, and its level may be that of noise that is known badly.
  if (reference.whiteness.is_white()) return std::max(1.0, mean_square);
  return std::max(1.0, mean_square * signals::correlation_time(fit::scaled_residuals(runs, reference.fit)));
}

double penalty_per_number(const FittedHypothesis& fitted, double overdispersion) {
  return std::log(std::max(std::exp(1.0), static_cast<double>(fitted.fit.samples()) / overdispersion));
}

double quasi_bic(const FittedHypothesis& fitted, double overdispersion) {
  return fitted.fit.objective() / overdispersion +
         static_cast<double>(fitted.hypothesis.size()) * penalty_per_number(fitted, overdispersion);
}

}  // namespace coilwright::measurement::identification
