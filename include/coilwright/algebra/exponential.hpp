#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// What x' = A x + u with a constant u makes of x in a time: x of its end is transition x + integral u. The transition
/// is the exponential of A times the time, and the integral that of the transitions up to there; (n, n) each.
struct HeldResponse {
  Eigen::MatrixXd transition;
  Eigen::MatrixXd integral;
};

/// By the series of a fraction of the time, and doubling: N. J. Higham, Functions of Matrices (2008), section 10.7.4.
/// A with finite elements; stiff ones cost a product for each factor of two.
[[nodiscard]] HeldResponse held_response(const Eigen::MatrixXd& matrix, double duration);

}  // namespace coilwright::algebra
