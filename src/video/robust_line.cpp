#include "video/robust_line.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace coilwright::video {
namespace {

double median_size(const Eigen::VectorXd& values) {
  std::vector<double> sizes(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) sizes[static_cast<std::size_t>(i)] = std::abs(values[i]);
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return *middle;
}

double robust_value(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(values.size());
  Eigen::VectorXd found;
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::MatrixXd normal = terms.transpose() * weights.asDiagonal() * terms;
    found = normal.ldlt().solve(terms.transpose() * (weights.asDiagonal() * values));
    const Eigen::VectorXd residuals = values - terms * found;
    const double scale = 1.4826 * median_size(residuals) + 1e-12;
    weights = (1.0 + (residuals.array() / (2.385 * scale)).square()).inverse();
  }
  return found[terms.cols() - 1];
}

constexpr Eigen::Index parts = 4;

// The part in which each row is.
std::vector<Eigen::Index> parts_of(const Eigen::VectorXd& column, const Eigen::VectorXd& times) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(times.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index row) { return times[row]; });
  std::vector<Eigen::Index> out(order.size());
  const double all = column.squaredNorm();
  double sum = 0.0;
  for (const Eigen::Index row : order) {
    const double share = all > 0.0 ? sum / all : 0.0;
    out[static_cast<std::size_t>(row)] = std::min(parts - 1, static_cast<Eigen::Index>(parts * share));
    sum += column[row] * column[row];
  }
  return out;
}

}  // namespace

LastCoefficient robust_last_coefficient(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values,
                                        const Eigen::VectorXd& times) {
  const std::vector<Eigen::Index> part_of = parts_of(terms.col(terms.cols() - 1), times);
  Eigen::Array<double, parts, 1> without;
  for (Eigen::Index part = 0; part < parts; ++part) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index row = 0; row < values.size(); ++row)
      if (part_of[static_cast<std::size_t>(row)] != part) kept.push_back(row);
    if (std::ssize(kept) <= terms.cols()) return {.sigma = std::numeric_limits<double>::infinity()};
    without[part] = robust_value(terms(kept, Eigen::all), values(kept));
  }
  return {.value = robust_value(terms, values),
          .sigma = std::sqrt((parts - 1.0) / parts * (without - without.mean()).square().sum())};
}

}  // namespace coilwright::video
