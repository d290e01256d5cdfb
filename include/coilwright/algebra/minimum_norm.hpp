#pragma once

#include <Eigen/Core>
#include <optional>

namespace coilwright::algebra {

/// Returns the shortest x with the least |matrix x - right|, also for a matrix without full rank, such as normal
/// matrices of numbers that records do not tell apart. The method is a complete orthogonal decomposition; a direction
/// belongs to the rank if its pivot exceeds `threshold` times the largest, by default the rounding of its size. Without
/// columns x is empty, and without rows it is zero.
[[nodiscard]] Eigen::VectorXd minimum_norm(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                           std::optional<double> threshold = std::nullopt);

/// Applies minimum_norm() to every column of `right`.
[[nodiscard]] Eigen::MatrixXd minimum_norm_columns(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

}  // namespace coilwright::algebra
