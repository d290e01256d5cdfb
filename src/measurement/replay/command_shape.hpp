#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace coilwright::measurement::replay {

/// The simplest command that explains a stretch of noisy readings: a constant, a polynomial of up to third degree, or a
/// sine about a constant. Most inputs of a laboratory are made of these, and a curve of so few numbers keeps far less
/// of the noise than any smoother.
struct CommandShape {
  /// Orthonormal columns that span the curves of this kind, (n, numbers); of a sine also that of its frequency.
  Eigen::MatrixXd basis{};
  Eigen::VectorXd values{};  ///< the curve at the samples, (n)
};

/// Nothing if no such curve leaves white noise of `sigma` (> 0): its mean square exceeds sigma^2 by more than four
/// standard deviations, or readings beside one another are still alike. At least eight readings.
[[nodiscard]] std::optional<CommandShape> command_shape(std::span<const double> times, std::span<const double> values,
                                                        double sigma);

}  // namespace coilwright::measurement::replay
