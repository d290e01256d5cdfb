#pragma once

#include <Eigen/Core>

#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// What a proposal is to achieve, as a scalar to minimise.
struct Goal {
  enum class Kind {
    gap,         ///< largest of (value_i - origin_i) / span_i: below 1 is inside the gap
    objective,   ///< sum of (value_i - origin_i) / span_i
    feasibility  ///< largest constraint
  };
  Kind kind{};
  Objectives origin{}, span{};  ///< of `gap` and `objective`
  double to_beat{};             ///< a smaller scalar is progress

  /// The scalar of minimised objectives and constraints, violation not considered.
  [[nodiscard]] double scalar(const Eigen::VectorXd& values, const Eigen::VectorXd& constraints) const;
  /// The same of an evaluated sample.
  [[nodiscard]] double scalar(const Sample& sample) const;
};

/// Scalar plus a steep price on violation (the largest constraint): what algorithms without constraints minimise, and
/// what candidates are ranked by. The price starts at 1, so that no feasible improvement ranks behind a violation.
[[nodiscard]] double priced(double scalar, double worst_constraint);

}  // namespace coilwright::sizing
