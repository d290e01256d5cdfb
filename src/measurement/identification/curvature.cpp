#include "measurement/identification/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "coilwright/algebra/spectral.hpp"
#include "measurement/fit/scales.hpp"
#include "measurement/identification/profile_likelihood.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The directions that the data determine, in scaled numbers.
struct DeterminedModes {
  Eigen::VectorXd scales;
  algebra::SymmetricModes modes;
  std::vector<bool> of_modes{};    // whether a direction is determined
  std::vector<bool> of_numbers{};  // whether a number is: others contribute to a direction that is not
};

DeterminedModes determined_modes(const FittedHypothesis& fitted) {
  constexpr double undetermined = 1e-12;  // fraction of the largest eigenvalue
  constexpr double contribution = 1e-6;   // squared component of a parameter
  const Eigen::VectorXd scales = fit::scales_at(fitted.hypothesis, fitted.fit.values);
  DeterminedModes out{
      .scales = scales,
      .modes = algebra::symmetric_modes(scales.asDiagonal() * fitted.fit.normal_matrix * scales.asDiagonal())};
  const double least = undetermined * out.modes.values.maxCoeff();
  for (const double value : out.modes.values) out.of_modes.push_back(value > least);
  for (Eigen::Index i = 0; i < scales.size(); ++i) {
    double hidden = 0.0;
    for (Eigen::Index k = 0; k < scales.size(); ++k)
      if (!out.of_modes[static_cast<std::size_t>(k)]) hidden += out.modes.vectors(i, k) * out.modes.vectors(i, k);
    out.of_numbers.push_back(hidden <= contribution);
  }
  return out;
}

// Of two scaled numbers, without the overdispersion.
double scaled_covariance(const DeterminedModes& there, Eigen::Index i, Eigen::Index j) {
  double sum = 0.0;
  for (Eigen::Index k = 0; k < there.modes.values.size(); ++k)
    if (there.of_modes[static_cast<std::size_t>(k)])
      sum += there.modes.vectors(i, k) * there.modes.vectors(j, k) / there.modes.values[k];
  return sum;
}

}  // namespace

Eigen::VectorXd standard_deviations(const FittedHypothesis& fitted, double overdispersion) {
  const Eigen::Index p = fitted.hypothesis.size();
  Eigen::VectorXd out = Eigen::VectorXd::Constant(p, infinity);
  if (p == 0) return out;
  const DeterminedModes there = determined_modes(fitted);
  for (Eigen::Index i = 0; i < p; ++i) {
    const double variance = scaled_covariance(there, i, i);
    if (there.of_numbers[static_cast<std::size_t>(i)] && variance > 0.0)
      out[i] = there.scales[i] * std::sqrt(overdispersion * variance);
  }
  return out;
}

Eigen::MatrixXd covariance(const FittedHypothesis& fitted, double overdispersion) {
  const Eigen::Index p = fitted.hypothesis.size();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(p, p);
  if (p == 0) return out;
  const DeterminedModes there = determined_modes(fitted);
  for (Eigen::Index i = 0; i < p; ++i)
    for (Eigen::Index j = 0; j < p; ++j)
      if (there.of_numbers[static_cast<std::size_t>(i)] && there.of_numbers[static_cast<std::size_t>(j)])
        out(i, j) = there.scales[i] * there.scales[j] * overdispersion * scaled_covariance(there, i, j);
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

void widen(Estimate& estimate, const fit::FitParameter& parameter, double variance) {
  const double reach = normal_95 * std::sqrt(variance);
  estimate.lower = estimate.value - std::hypot(estimate.value - estimate.lower, reach);
  estimate.upper = estimate.value + std::hypot(estimate.upper - estimate.value, reach);
  if (estimate.lower < parameter.lower) estimate.lower = -infinity;
  if (estimate.upper > parameter.upper) estimate.upper = infinity;
  estimate.determined = std::isfinite(estimate.lower) || std::isfinite(estimate.upper);
}

}  // namespace coilwright::measurement::identification
