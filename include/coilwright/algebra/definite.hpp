#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// Solves matrix x = right for a symmetric, positive definite matrix, by Cholesky's factors. For another matrix the
/// answer is meaningless, and no error is reported.
[[nodiscard]] Eigen::VectorXd solve_definite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// The inverse of such a matrix.
[[nodiscard]] Eigen::MatrixXd inverse_of_definite(const Eigen::MatrixXd& matrix);

}  // namespace coilwright::algebra
