#include "measurement/signals/polynomial_contrasts.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace coilwright::measurement::signals {
namespace {

using Eigen::VectorXd;

// Weights of the residual at the middle sample, of unit length; empty if the polynomial always passes through that
// sample. Gram-Schmidt orthogonalisation, applied twice, of the powers of the abscissa: columns that repeated abscissae
// make dependent are dropped.
VectorXd residual_weights(std::span<const double> at, int degree) {
  const auto points = static_cast<Eigen::Index>(at.size());
  const Eigen::Index middle = points / 2;
  const double half_width = std::max(at.back() - at[middle], at[middle] - at.front());
  VectorXd place(points);
  for (Eigen::Index i = 0; i < points; ++i) place[i] = half_width > 0.0 ? (at[i] - at[middle]) / half_width : 0.0;

  Eigen::MatrixXd basis(points, degree + 1);
  Eigen::Index rank = 0;
  VectorXd column = VectorXd::Constant(points, 1.0);
  for (int power = 0; power <= degree; ++power) {
    const double length = column.norm();
    VectorXd rest = column;
    for (int pass = 0; pass < 2; ++pass)
      rest -= basis.leftCols(rank) * (basis.leftCols(rank).transpose() * rest).eval();
    constexpr double dependent = 1e-9;
    if (rest.norm() > dependent * length) {
      basis.col(rank) = rest.normalized();
      column = basis.col(rank).cwiseProduct(place);
      ++rank;
    } else {
      break;
    }
  }
  VectorXd weights = -basis.leftCols(rank) * basis.row(middle).head(rank).transpose();
  weights[middle] += 1.0;
  constexpr double interpolated = 1e-5;
  if (weights.norm() < interpolated) return {};
  return weights.normalized();
}

bool is_evenly_spaced(std::span<const double> at) {
  const double step = (at.back() - at.front()) / static_cast<double>(at.size() - 1);
  constexpr double jitter = 1e-3;
  for (std::size_t i = 0; i < at.size(); ++i)
    if (std::abs(at[i] - at.front() - step * static_cast<double>(i)) > jitter * step) return false;
  return true;
}

}  // namespace

std::vector<double> contrasts(const Curve& curve, ContrastShape shape) {
  const auto points = static_cast<std::size_t>(shape.points);
  std::vector<double> found;
  if (curve.values.size() < points) return found;
  const std::size_t windows = curve.values.size() - points + 1;
  found.reserve(windows);
  const bool same_weights = is_evenly_spaced(curve.at);
  VectorXd weights;
  for (std::size_t first = 0; first < windows; ++first) {
    if (first == 0 || !same_weights)
      weights = residual_weights(std::span(curve.at).subspan(first, points), shape.degree);
    if (weights.size() == 0) continue;
    // Relative to the value in the middle of the window: values far from zero would cost digits.
    const double middle = curve.values[first + points / 2];
    double sum = 0.0;
    for (std::size_t i = 0; i < points; ++i)
      sum += weights[static_cast<Eigen::Index>(i)] * (curve.values[first + i] - middle);
    found.push_back(sum);
  }
  return found;
}

double contrast_redundancy(ContrastShape shape) {
  std::vector<double> at(static_cast<std::size_t>(shape.points));
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = static_cast<double>(i);
  const VectorXd weights = residual_weights(at, shape.degree);
  double sum = 1.0;
  for (Eigen::Index lag = 1; lag < weights.size(); ++lag) {
    const double correlation = weights.head(weights.size() - lag).dot(weights.tail(weights.size() - lag));
    sum += 2.0 * correlation * correlation;
  }
  return sum;
}

}  // namespace coilwright::measurement::signals
