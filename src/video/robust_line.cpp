#include "video/robust_line.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
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

}  // namespace

LastCoefficient robust_last_coefficient(const Eigen::MatrixXd& terms, const Eigen::VectorXd& values) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(values.size());
  Eigen::MatrixXd inverse;
  Eigen::VectorXd found;
  double scale = 0.0;
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::MatrixXd normal = terms.transpose() * weights.asDiagonal() * terms;
    inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(terms.cols(), terms.cols()));
    found = inverse * (terms.transpose() * (weights.asDiagonal() * values));
    const Eigen::VectorXd residuals = values - terms * found;
    scale = 1.4826 * median_size(residuals) + 1e-12;
    weights = (1.0 + (residuals.array() / (2.385 * scale)).square()).inverse();
  }
  const Eigen::Index last = terms.cols() - 1;
  return {.value = found[last], .sigma = scale * std::sqrt(std::max(0.0, inverse(last, last)))};
}

}  // namespace coilwright::video
