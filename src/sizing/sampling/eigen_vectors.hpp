#pragma once

#include <Eigen/Core>
#include <vector>

namespace coilwright::sizing {

/// A view of `values`, which must outlive it.
[[nodiscard]] inline Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

[[nodiscard]] inline std::vector<double> as_std(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

}  // namespace coilwright::sizing
