#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// The x with matrix x = right, of a symmetric and positive definite matrix, by Cholesky's factors. Of another matrix
/// the answer means nothing, and nothing says so.
[[nodiscard]] Eigen::VectorXd solve_definite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// The inverse of such a matrix.
[[nodiscard]] Eigen::MatrixXd inverse_of_definite(const Eigen::MatrixXd& matrix);

}  // namespace coilwright::algebra
