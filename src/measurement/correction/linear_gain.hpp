#pragma once

#include <Eigen/Core>

#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::correction {

/// What a correction promises before it is fitted, by the slopes of all residuals at zero correction.
struct LinearGain {
  double deviation{};      ///< standard deviation of its coefficients for which it promises most
  double fall{};           ///< of the squared residual of runs left out in turn; below zero: a rise
  Eigen::VectorXd step{};  ///< of all parameters, from zero correction to the best one on all runs
};

/// `at_zero` is a fit's residuals and slopes where the last `coefficients` numbers of `hypothesis`, those of the
/// correction, are zero. Each run is left out in turn; what all other numbers gain by themselves does not count.
[[nodiscard]] LinearGain linear_gain(const fit::Hypothesis& hypothesis, const fit::Fit& at_zero, int coefficients);

}  // namespace coilwright::measurement::correction
