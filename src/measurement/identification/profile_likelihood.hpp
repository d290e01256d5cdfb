#pragma once

#include <Eigen/Core>
#include <span>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// Quantiles at 95 %: of chi-square with one degree of freedom, and of the normal distribution on both sides.
inline constexpr double chi_square_95 = 3.8414588206941254;
inline constexpr double normal_95 = 1.959963984540054;

/// The profile likelihood of one parameter: the least chi-square at held values of it, all other parameters refitted.
/// A number whose physical range has zero at most at its end, and that is positive, is profiled in its logarithm,
/// because the data may leave decades of it open. Refers to runs and fit.
class ProfileLikelihood {
 public:
  ProfileLikelihood(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted, Eigen::Index parameter,
                    double overdispersion);

  /// The value at which the 95 % limit is passed below (-1) or above (1) the estimate, at most at the physical bound;
  /// an infinity if it is not passed. `deviation`: standard deviation from the curvature; may be infinite.
  [[nodiscard]] double crossing(double direction, double deviation);

  /// The smallest chi-square along the profile so far, and its parameters: those of the fit if none was smaller.
  [[nodiscard]] double best_chi_square() const { return best_chi_square_; }
  [[nodiscard]] const Eigen::VectorXd& best_values() const { return best_values_; }

 private:
  [[nodiscard]] double coordinate(double value) const;
  [[nodiscard]] double value_at(double coordinate) const;
  [[nodiscard]] double first_step(double estimate, double deviation) const;
  [[nodiscard]] double above_limit(double coordinate);
  [[nodiscard]] double root(double inside, double inside_value, double outside, double outside_value, double tolerance);

  std::span<const replay::PreparedRun> runs_;
  const FittedHypothesis& fitted_;
  Eigen::Index parameter_;
  double overdispersion_;
  double lower_{}, upper_{}, scale_{};
  bool logarithmic_{};
  Eigen::VectorXd along_;        // change of all parameters by that of this one, by the curvature at the optimum
  Eigen::VectorXd last_values_;  // parameters of the last fit, from which the next one starts
  Eigen::VectorXd best_values_;
  double best_chi_square_{};
};

}  // namespace coilwright::measurement::identification
