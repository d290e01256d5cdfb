#pragma once

#include <Eigen/Core>

#include "coilwright/measurement/compare/estimate.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// Standard deviations of all parameters from the curvature at the optimum, SI; infinite where the data do not
/// determine one. Where declared numbers are off, all together, by more than chance has it (1 %), the tolerances behind
/// them are taken larger by Birge's ratio, the root of the mean square of the tolerances moved (R. T. Birge, Phys. Rev.
/// 40 (1932) 207): nobody knows those of the others to be better.
[[nodiscard]] Eigen::VectorXd standard_deviations(const FittedHypothesis& fitted, double overdispersion);

/// What the data leave of all parameters together, SI: zeros in the rows and columns of those that they do not
/// determine. Elsewhere its diagonal is the square of standard_deviations().
[[nodiscard]] Eigen::MatrixXd covariance(const FittedHypothesis& fitted, double overdispersion);

/// The 95 % interval of a normal distribution, open where it passes a physical bound.
[[nodiscard]] Estimate local_estimate(const fit::FitParameter& parameter, double value, double deviation);

}  // namespace coilwright::measurement::compare
