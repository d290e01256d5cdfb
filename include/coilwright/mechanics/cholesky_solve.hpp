#pragma once

#include <Eigen/Core>

namespace coilwright::mechanics {

/// Solves x <- L^-1 x in place, with L lower triangular in the lower triangle of `factor`, (n, n):
/// Eigen::LLT::matrixLLT(). Plain loops suit the few rows of a contact problem: Eigen's own solution, made for many
/// rows, took a tenth of a step of the crawling robot. `x` has n elements.
template <typename Matrix, typename Vector>
inline void solve_lower(const Matrix& factor, Vector&& x) {
  const Eigen::Index n = factor.rows();
  for (Eigen::Index j = 0; j < n; ++j) {
    x[j] /= factor(j, j);
    for (Eigen::Index k = j + 1; k < n; ++k) x[k] -= factor(k, j) * x[j];
  }
}

/// Solves x <- L^-T x in place: after solve_lower the solution of L L^T x = b.
template <typename Matrix, typename Vector>
inline void solve_upper(const Matrix& factor, Vector&& x) {
  const Eigen::Index n = factor.rows();
  for (Eigen::Index j = n; j-- > 0;) {
    for (Eigen::Index k = j + 1; k < n; ++k) x[j] -= factor(k, j) * x[k];
    x[j] /= factor(j, j);
  }
}

}  // namespace coilwright::mechanics
