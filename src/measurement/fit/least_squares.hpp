#pragma once

#include <Eigen/Core>
#include <optional>

#include "measurement/fit/counted.hpp"
#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::fit {

/// What a least-squares problem varies, and the derivatives at its optimum.
enum class Unknowns {
  initial_states,                ///< parameters are kept; derivatives with respect to them are zero
  initial_states_with_jacobian,  ///< parameters are kept; derivatives with respect to them are taken all the same
  all                            ///< parameters and initial states
};

/// The end of a least-squares problem. The initial states are in the blocks.
struct Optimum {
  Eigen::VectorXd parameters{};
  ResidualValues values{};
};

/// Minimises the sum of squared residuals of `blocks`, which were built for `request`, by Ceres. Nothing if the model
/// at the start cannot be simulated or the solver finds no step.
[[nodiscard]] Counted<std::optional<Optimum>> least_squares(const FitRequest& request, ResidualBlocks& blocks,
                                                            Unknowns unknowns);

}  // namespace coilwright::measurement::fit
