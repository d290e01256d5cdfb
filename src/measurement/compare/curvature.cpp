#include "measurement/compare/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coilwright/algebra/spectral.hpp"
#include "coilwright/measurement/compare/decision_thresholds.hpp"
#include "measurement/compare/profile_likelihood.hpp"
#include "measurement/fit/scales.hpp"

namespace coilwright::measurement::compare {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The square of Birge's ratio of the declared numbers: 1 as long as chance can have moved them together as far as they
// are.
double squared_birge_ratio(const FittedHypothesis& fitted) {
  if (probability_of_declared_numbers(fitted) >= decision_thresholds.least_probability) return 1.0;
  const auto count = std::ranges::count_if(fitted.hypothesis.parameters(), &fit::FitParameter::has_prior);
  return std::max(1.0, fitted.fit.prior_chi_square / static_cast<double>(count));
}

// What data and priors say together of the numbers. Where some are off by far more than their tolerances, nobody knows
// that of the others to be better: all tolerances are taken larger by Birge's ratio.
Eigen::MatrixXd information(const FittedHypothesis& fitted) {
  const fit::Fit& there = fitted.fit;
  const double squared_ratio = squared_birge_ratio(fitted);
  if (squared_ratio == 1.0) return there.normal_matrix;
  const Eigen::MatrixXd prior = fitted.hypothesis.prior_jacobian(there.values, there.model_error);
  return there.normal_matrix - (1.0 - 1.0 / squared_ratio) * prior.transpose() * prior;
}

}  // namespace

Eigen::VectorXd standard_deviations(const FittedHypothesis& fitted, double overdispersion) {
  const Eigen::Index p = fitted.hypothesis.size();
  const Eigen::VectorXd scales = fit::scales_at(fitted.hypothesis, fitted.fit.values);
  const Eigen::MatrixXd scaled = scales.asDiagonal() * information(fitted) * scales.asDiagonal();
  Eigen::VectorXd out = Eigen::VectorXd::Constant(p, infinity);
  if (p == 0) return out;
  // A direction that the data do not determine leaves only those parameters undetermined that contribute to it.
  constexpr double undetermined = 1e-12;  // fraction of the largest eigenvalue
  constexpr double contribution = 1e-6;   // squared component of a parameter
  const algebra::SymmetricModes modes = algebra::symmetric_modes(scaled);
  const double least = undetermined * modes.values.maxCoeff();
  for (Eigen::Index i = 0; i < p; ++i) {
    double variance = 0.0;
    double hidden = 0.0;
    for (Eigen::Index k = 0; k < p; ++k) {
      const double share = modes.vectors(i, k) * modes.vectors(i, k);
      if (modes.values[k] > least)
        variance += share / modes.values[k];
      else
        hidden += share;
    }
    if (hidden <= contribution && variance > 0.0) out[i] = scales[i] * std::sqrt(overdispersion * variance);
  }
  return out;
}

Estimate local_estimate(const fit::FitParameter& parameter, double value, double deviation) {
  Estimate out{.key = parameter.key, .value = value};
  out.lower = value - normal_95 * deviation;
  out.upper = value + normal_95 * deviation;
  if (out.lower < parameter.lower) out.lower = -infinity;
  if (out.upper > parameter.upper) out.upper = infinity;
  out.determined = std::isfinite(out.lower) || std::isfinite(out.upper);
  return out;
}

}  // namespace coilwright::measurement::compare
