#pragma once

#include <Eigen/Core>

#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// What a subproblem of the search is to achieve, as a scalar to minimise.
struct Goal {
  /// How the scalar is formed.
  enum class Kind {
    gap,         ///< largest of (value_i - origin_i) / span_i; below 1 the point lies inside the gap
    objective,   ///< sum of (value_i - origin_i) / span_i
    feasibility  ///< largest constraint
  };
  Kind kind{};
  Objectives origin{}, span{};  ///< offset and scale of each objective, for `gap` and `objective`
  double to_beat{};             ///< a design with a smaller scalar is progress

  /// The scalar of minimised objectives and constraints, without regard to violation.
  [[nodiscard]] double scalar(const Eigen::VectorXd& values, const Eigen::VectorXd& constraints) const;
  /// The same of an evaluated sample.
  [[nodiscard]] double scalar(const Sample& sample) const;
};

/// Merit of a design: the scalar plus a penalty on the largest constraint, if that is above 0. The penalty starts at 1,
/// so that no feasible improvement ranks behind a violation.
[[nodiscard]] double penalised(double scalar, double worst_constraint);

}  // namespace coilwright::sizing
