#pragma once

#include <Eigen/Core>

namespace coilwright::video {

/// The last coefficient of a linear fit.
struct LastCoefficient {
  double value{};
  double sigma{};  ///< infinite or not a number where the rows do not tell the coefficient
};

/// Least squares of `values` by the columns of `terms` (more rows than columns) in which rows that are far off count
/// less, by Cauchy's weights, scaled by the median of the residuals. The standard deviation is the jackknife's over
/// four parts of the time, in each of which the last column says as much: errors that are alike from one row to the
/// next, and terms that hardly differ, enter it. `times`: one for each row, in any order.
[[nodiscard]] LastCoefficient robust_last_coefficient(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values,
                                                      const Eigen::VectorXd& times);

}  // namespace coilwright::video
