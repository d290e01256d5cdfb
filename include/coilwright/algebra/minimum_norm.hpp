#pragma once

#include <Eigen/Core>
#include <optional>

namespace coilwright::algebra {

/// The shortest x with the least |matrix x - right|: a solution also where `matrix` does not have its full rank (normal
/// matrices of numbers that records do not tell apart). By a complete orthogonal decomposition; a direction is in the
/// rank where its pivot is larger than `threshold` of the largest, by default the rounding of its size. Where nothing
/// is unknown (no columns) x is empty, and without rows it is zero.
[[nodiscard]] Eigen::VectorXd minimum_norm(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                           std::optional<double> threshold = std::nullopt);

/// The same for every column of `right`.
[[nodiscard]] Eigen::MatrixXd minimum_norm_columns(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

}  // namespace coilwright::algebra
