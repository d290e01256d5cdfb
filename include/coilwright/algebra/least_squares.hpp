#pragma once

#include <Eigen/Core>

namespace coilwright::algebra {

/// The x with the least |columns x - values|, by Householder reflections. `columns` is (n, p) of rank p, p <= n.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values);

/// (n, p): orthonormal columns that span those of `columns`, (n, p) of rank p, p <= n. The first k span its first k.
[[nodiscard]] Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

}  // namespace coilwright::algebra
