#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "measurement/identification/discrepancy.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// What the records and the priors say of one hypothesis.
struct WeighedFit {
  double log_evidence{};           ///< natural logarithm, up to a constant of the records and the declared model
  Discrepancy discrepancy{};       ///< the most probable one; none where noise of some colour is more probable
  double probability_of_noise{};   ///< that what is missing is below a tenth of the noise
  double values_of_discrepancy{};  ///< how many values of it all records together tell: values_told()
  Eigen::VectorXd values{};        ///< the most probable parameters, SI; inside their bounds
  Eigen::MatrixXd covariance{};    ///< of them, SI; large where neither records nor priors tell
  std::vector<Eigen::Index> first_of_effects{};  ///< place of the first number of each effect among them
};

/// The evidence of a hypothesis and the posterior of its parameters, by Laplace's approximation at its fit:
/// - the records are what the hypothesis makes, linear in its parameters and in the local numbers of each window about
///   the fit, with a discrepancy of its own in each channel of each window and with noise. Where the noise's level was
///   estimated, its own uncertainty is integrated out (a Student-t likelihood of each series);
/// - a declared number is known to its tolerance by Student's t with 4 degrees of freedom, so that one may be far off
///   without drawing the others along; where its prior has an end (faces), as probable from there to its bound as at
///   that end; the numbers of effects as prior_of_numbers() says;
/// - what may be missing, or colour the noise, is summed over all_that_may_be_left(); what it does to the linear part
///   is taken from its most probable place.
/// One mode. Where the fit's derivatives promise a higher density beside the fit, as they do far from the noise, the
/// model is simulated there, and the hypothesis is credited with what that shows: a lower bound. (Kass and Raftery, J.
/// Am. Stat. Assoc. 90 (1995) 773, section 4.1; Lange, Little and Taylor, J. Am. Stat. Assoc. 84 (1989) 881 on
/// Student's t.)
[[nodiscard]] WeighedFit weighed(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                 const actuator::RigScale& scale);

}  // namespace coilwright::measurement::identification
