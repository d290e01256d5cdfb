#pragma once

#include <Eigen/Core>

namespace coilwright::video {

/// The last coefficient of a linear fit.
struct LastCoefficient {
  double value{};
  double sigma{};
};

/// Least squares of `values` by the columns of `terms` (more rows than columns) in which rows that are far off count
/// less, by Cauchy's weights, scaled by the median of the residuals.
[[nodiscard]] LastCoefficient robust_last_coefficient(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values);

}  // namespace coilwright::video
