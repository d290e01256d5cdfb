#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>

namespace coilwright::measurement::planning {

/// What one explanation expects of n readings, each over its noise: a normal distribution about `mean`, (n), whose
/// covariance is the noise's, the unit matrix, and that of what the explanation's own numbers leave open, spread
/// spread^T; `spread` is (n, k).
struct Expectation {
  double probability{};  ///< of the explanation before the readings, over that of all that are compared; >= 0
  Eigen::VectorXd mean{};
  Eigen::MatrixXd spread{};
  /// The readings where the numbers have moved by so many standard deviations along each column, (k): near mean +
  /// spread moves. Nothing where they cannot be. Empty: just that.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd&)> moved{};
};

/// How many bits are open between explanations with these probabilities, which add up to 1: Shannon's entropy.
[[nodiscard]] double open_bits(std::span<const double> probabilities);

/// How many of these bits stay open after the readings, at most, on average over what they may show; its natural
/// logarithm, since readings of a good run leave next to none: what a lower bound of the mutual information of readings
/// and explanations leaves, from the Bhattacharyya distances of all pairs (Kolchinsky and Tracey, Entropy 19 (2017)
/// 361, eq. 10 with alpha = 1/2), each where the numbers of both have moved towards each other and without its part of
/// the determinants, which only adds. That of open_bits() where all expect the same; minus infinity of one explanation.
/// Probabilities add up to 1; all means and spreads have the same number of rows.
[[nodiscard]] double log_remaining_bits(std::span<const Expectation> explanations);

}  // namespace coilwright::measurement::planning
