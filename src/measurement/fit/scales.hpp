#pragma once

#include <Eigen/Core>
#include <cmath>

#include "measurement/fit/hypothesis.hpp"

namespace coilwright::measurement::fit {

/// Typical changes of a hypothesis where a fit found `values`: Hypothesis::scales(), but a free number that is more
/// than a hundred times its own changes as it is itself. What was declared (a damping of next to nothing) is no measure
/// of it then.
[[nodiscard]] inline Eigen::VectorXd scales_at(const Hypothesis& hypothesis, const Eigen::VectorXd& values) {
  constexpr double no_measure = 100.0;
  Eigen::VectorXd out = hypothesis.scales();
  for (Eigen::Index i = 0; i < out.size(); ++i)
    if (!hypothesis.parameters()[static_cast<std::size_t>(i)].has_prior() && std::abs(values[i]) > no_measure * out[i])
      out[i] = std::abs(values[i]);
  return out;
}

}  // namespace coilwright::measurement::fit
