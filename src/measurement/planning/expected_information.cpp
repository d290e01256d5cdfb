#include "measurement/planning/expected_information.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "coilwright/algebra/definite.hpp"

namespace coilwright::measurement::planning {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd readings_after(const Expectation& expectation, const VectorXd& moves) {
  if (expectation.moved)
    if (std::optional<VectorXd> readings = expectation.moved(moves)) return *std::move(readings);
  return expectation.mean + expectation.spread * moves;
}

// Eight times the quadratic part of the Bhattacharyya distance of two normal distributions (Bull. Calcutta Math. Soc.
// 35 (1943) 99): with their mean covariance I + U U^T the least |d - U x|^2 + |x|^2, by Gauss and Newton's steps over
// the readings as they are. The other part, of the determinants, is positive: without it the distance is no larger, and
// does not take two families of readings that bend for two that cross.
double squared_distance(const Expectation& one, const Expectation& other) {
  constexpr int steps = 3;
  constexpr double half = std::numbers::sqrt2 / 2.0;
  const Eigen::Index own = one.spread.cols();
  const Eigen::Index size = own + other.spread.cols();
  VectorXd apart = one.mean - other.mean;
  double least = apart.squaredNorm();
  if (size == 0) return least;
  MatrixXd both(one.mean.size(), size);
  both << half * one.spread, half * other.spread;
  const MatrixXd matrix = MatrixXd::Identity(size, size) + both.transpose() * both;
  VectorXd towards = VectorXd::Zero(size);
  for (int step = 0; step < steps; ++step) {
    towards += algebra::solve_definite(matrix, both.transpose() * apart - towards);
    apart = readings_after(one, -half * towards.head(own)) - readings_after(other, half * towards.tail(size - own));
    least = std::min(least, apart.squaredNorm() + towards.squaredNorm());
  }
  return least;
}

double log_of_sum(const std::vector<double>& logarithms) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const double each : logarithms) largest = std::max(largest, each);
  if (std::isinf(largest)) return largest;
  double sum = 0.0;
  for (const double each : logarithms) sum += std::exp(each - largest);
  return largest + std::log(sum);
}

// ln ln (1 + exp x).
double log_log1p_exp(double x) {
  constexpr double linear = -36.0;  // below it the inner logarithm is exp x to rounding
  return x < linear ? x : std::log(std::log1p(std::exp(x)));
}

}  // namespace

double open_bits(std::span<const double> probabilities) {
  double sum = 0.0;
  for (const double each : probabilities)
    if (each > 0.0) sum -= each * std::log2(each);
  return sum;
}

double log_remaining_bits(std::span<const Expectation> explanations) {
  std::vector<const Expectation*> possible;
  for (const Expectation& each : explanations)
    if (each.probability > 0.0) possible.push_back(&each);
  // Of each the odds of the others, as far as they overlap. A distance is that of both, with simulations in it.
  std::vector<std::vector<double>> odds(possible.size());
  for (std::size_t i = 0; i < possible.size(); ++i)
    for (std::size_t j = i + 1; j < possible.size(); ++j) {
      const double ratio = std::log(possible[j]->probability / possible[i]->probability);
      const double overlap = squared_distance(*possible[i], *possible[j]) / 8.0;
      odds[i].push_back(ratio - overlap);
      odds[j].push_back(-ratio - overlap);
    }
  std::vector<double> parts;
  for (std::size_t i = 0; i < possible.size(); ++i)
    parts.push_back(std::log(possible[i]->probability) + log_log1p_exp(log_of_sum(odds[i])));
  return log_of_sum(parts) - std::log(std::numbers::ln2);
}

}  // namespace coilwright::measurement::planning
