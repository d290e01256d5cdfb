#pragma once

namespace coilwright::mechanics {

/// Factorises A for the solution of A x = b, with A (n, n) symmetric and positive definite, for the few rows of a
/// chain: in three loops, because Eigen's decompositions of matrices of run-time size cost more than the rest of the
/// right-hand side of two joints. No pivoting, no heap. If A is not positive definite the results are not finite or
/// meaningless.
///
/// A = U^T D U with U upper triangular and ones on its diagonal. Reads and writes only the upper triangle of `a`: U
/// above the diagonal, the inverse of D on it.
template <typename Matrix>
inline void factorize_ldlt(Matrix& a, int n) {
  for (int j = 0; j < n; ++j) {
    const double inverse = 1.0 / a(j, j);
    for (int k = j + 1; k < n; ++k) {
      const double factor = a(j, k) * inverse;
      for (int i = j + 1; i <= k; ++i) a(i, k) -= a(j, i) * factor;
    }
    for (int k = j + 1; k < n; ++k) a(j, k) *= inverse;
    a(j, j) = inverse;
  }
}

/// Solves x <- U^-T x in place, with the factors of factorize_ldlt; `x` has n elements.
template <typename Matrix, typename Vector>
inline void solve_lower_ldlt(const Matrix& factors, int n, Vector&& x) {
  for (int j = 0; j < n; ++j)
    for (int k = j + 1; k < n; ++k) x[k] -= factors(j, k) * x[j];
}

/// Solves x <- U^-1 D^-1 x in place: after solve_lower_ldlt, the solution of A x = b.
template <typename Matrix, typename Vector>
inline void solve_upper_ldlt(const Matrix& factors, int n, Vector&& x) {
  for (int j = 0; j < n; ++j) x[j] *= factors(j, j);
  for (int k = n - 1; k > 0; --k)
    for (int j = 0; j < k; ++j) x[j] -= factors(j, k) * x[k];
}

}  // namespace coilwright::mechanics
