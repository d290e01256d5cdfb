#pragma once

#include <Eigen/Core>

#include "coilwright/measurement/identification/estimate.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// Standard deviations of all parameters from the curvature at the optimum, SI; infinite where the data do not
/// determine one.
[[nodiscard]] Eigen::VectorXd standard_deviations(const FittedHypothesis& fitted, double overdispersion);

/// What the data leave of all parameters together, SI: zeros in the rows and columns of those that they do not
/// determine. Elsewhere its diagonal is the square of standard_deviations().
[[nodiscard]] Eigen::MatrixXd covariance(const FittedHypothesis& fitted, double overdispersion);

/// The 95 % interval of a normal distribution, open where it passes a physical bound.
[[nodiscard]] Estimate local_estimate(const fit::FitParameter& parameter, double value, double deviation);

/// Widens an interval by a variance that is added to its own, whatever that is from (the curvature, a profile, a scan
/// of local optima): on each side, so that it stays as uneven as it is. Ends that pass a physical bound are open, as
/// those are that the data do not set.
void widen(Estimate& estimate, const fit::FitParameter& parameter, double variance);

}  // namespace coilwright::measurement::identification
