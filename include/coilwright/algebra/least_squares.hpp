#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// Returns the x with the least |columns x - values|, by Householder reflections. `columns` is (n, p) of rank p, p <=
/// n.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values);

/// Returns orthonormal columns, (n, p), that span those of `columns`, which is (n, p) of rank p, p <= n. The first k
/// span its first k.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace coilwright::algebra
