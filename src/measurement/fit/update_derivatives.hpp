#pragma once

#include <Eigen/Core>

#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::fit {

/// What a step has moved, and what counts as much in each number.
struct StepTaken {
  Eigen::VectorXd parameters{};        ///< change of each
  Eigen::VectorXd parameter_scales{};  ///< > 0
  Eigen::VectorXd local{};             ///< change of each local number of the block
  Eigen::VectorXd local_scales{};      ///< > 0
};

/// Corrects derivatives of a block, which are those where the step began, by the smallest change with which they give
/// the change of the residuals that the step has shown (each number over its scale): after few steps they are right in
/// the directions in which a fit goes, at no cost. Says nothing of directions in which it does not go. Source: Broyden,
/// Math. Comp. 19 (1965) 577.
void update_derivatives(const StepTaken& step, const Eigen::VectorXd& residuals_before, ResidualValues::Block& block);

}  // namespace coilwright::measurement::fit
