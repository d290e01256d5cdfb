#include "sizing/sampling/goal.hpp"

#include <algorithm>
#include <limits>

namespace coilwright::sizing {

double Goal::scalar(const Eigen::VectorXd& values, const Eigen::VectorXd& constraints) const {
  if (kind == Kind::feasibility) return constraints.maxCoeff();
  double result = kind == Kind::objective ? 0.0 : -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double term = (values[i] - origin[static_cast<std::size_t>(i)]) / span[static_cast<std::size_t>(i)];
    result = kind == Kind::objective ? result + term : std::max(result, term);
  }
  return result;
}

double Goal::scalar(const Sample& sample) const {
  using Map = Eigen::Map<const Eigen::VectorXd>;
  return scalar(Map(sample.values.data(), static_cast<Eigen::Index>(sample.values.size())),
                Map(sample.constraints.data(), static_cast<Eigen::Index>(sample.constraints.size())));
}

double penalised(double scalar, double worst_constraint) {
  return worst_constraint > 0 ? scalar + 1.0 + 10.0 * worst_constraint : scalar;
}

}  // namespace coilwright::sizing
