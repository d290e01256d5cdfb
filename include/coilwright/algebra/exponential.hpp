#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// Response of x' = A x + u, with constant u, over a duration: x at its end is transition x + integral u. The
/// transition is the exponential of A times the duration, and the integral is the integral of the transitions up to
/// there; (n, n) each.
struct HeldResponse {
  Eigen::MatrixXd transition;
  Eigen::MatrixXd integral;
};

/// Computes the response by the series of a fraction of the duration and repeated doubling: N. J. Higham, Functions of
/// Matrices (2008), section 10.7.4. A has finite elements; a stiff A costs a product for each factor of two.
[[nodiscard]] HeldResponse held_response(const Eigen::MatrixXd& matrix, double duration);

}  // namespace coilwright::algebra
