#include "measurement/fit/update_derivatives.hpp"

namespace coilwright::measurement::fit {

void update_derivatives(const StepTaken& step, const Eigen::VectorXd& residuals_before, ResidualValues::Block& block) {
  const Eigen::VectorXd parameters = step.parameters.cwiseQuotient(step.parameter_scales);
  const Eigen::VectorXd local = step.local.cwiseQuotient(step.local_scales);
  const double square = parameters.squaredNorm() + local.squaredNorm();
  if (!(square > 0.0)) return;
  const Eigen::VectorXd missing =
      (block.residuals - residuals_before - block.jacobian * step.parameters - block.local_jacobian * step.local) /
      square;
  block.jacobian += missing * parameters.cwiseQuotient(step.parameter_scales).transpose();
  block.local_jacobian += missing * local.cwiseQuotient(step.local_scales).transpose();
}

}  // namespace coilwright::measurement::fit
