#pragma once

#include <Eigen/Core>
#include <optional>

#include "measurement/fit/residual_blocks.hpp"

namespace coilwright::measurement::fit {

/// What a least-squares problem varies, and the derivatives at its optimum.
enum class Unknowns {
  local_numbers,                ///< parameters are kept; derivatives with respect to them are zero
  local_numbers_with_jacobian,  ///< parameters are kept; derivatives with respect to them are taken all the same
  all                           ///< parameters and local numbers
};

/// The end of a least-squares problem. The local numbers are in the blocks.
struct Optimum {
  Eigen::VectorXd parameters{};
  ResidualValues values{};
};

/// Minimises the sum of squared residuals of `blocks`, which were built for `request`, and of the prior of the
/// hypothesis, by Ceres. Where every step leads to numbers that make no model or no motion the optimum is the start.
/// Nothing if the model at the start cannot be simulated.
[[nodiscard]] std::optional<Optimum> least_squares(const FitRequest& request, ResidualBlocks& blocks,
                                                   Unknowns unknowns);

}  // namespace coilwright::measurement::fit
