#pragma once

#include <Eigen/Core>
#include <limits>
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

/// The noise of readings, as far as it is known.
struct ReadingNoise {
  double sigma{};                                            ///< standard deviation, > 0
  double freedom = std::numeric_limits<double>::infinity();  ///< degrees of freedom of its square; infinite if exact
};

/// Nothing if no such curve leaves white noise of that size: its mean square exceeds that of the noise by more than
/// four standard deviations of their ratio, or readings beside one another are still alike. At least eight readings.
[[nodiscard]] std::optional<CommandShape> command_shape(std::span<const double> times, std::span<const double> values,
                                                        const ReadingNoise& noise);

}  // namespace coilwright::measurement::replay
