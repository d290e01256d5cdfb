#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// Eigenvalues of a symmetric matrix, ascending, and its orthonormal eigenvectors as columns in their order. Both are
/// empty for an empty matrix.
struct SymmetricModes {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
[[nodiscard]] SymmetricModes symmetric_modes(const Eigen::MatrixXd& matrix);

/// Singular values, descending; none for an empty matrix.
[[nodiscard]] Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

}  // namespace coilwright::algebra
