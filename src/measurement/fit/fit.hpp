#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/whiteness/scaled_residual.hpp"
#include "measurement/fit/counted.hpp"
#include "measurement/fit/fit_request.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::fit {

/// The residuals of one run over its noise, and what their derivatives say of the parameters.
struct RunFit {
  Eigen::VectorXd residuals{};    ///< (measured - predicted) / sigma: window after window, channel after channel
  Eigen::VectorXd predictions{};  ///< SI, in the same order
  /// Normal equations of this run, the initial state of each window eliminated: matrix (p, p) and gradient (p).
  Eigen::MatrixXd normal_matrix{};
  Eigen::VectorXd gradient{};
  std::vector<simulation::State> initial_states{};  ///< of each window
};

/// A hypothesis fitted to all runs.
struct Fit {
  Eigen::VectorXd values{};  ///< of Hypothesis::parameters
  double chi_square{};       ///< sum of all squared residuals
  std::vector<RunFit> runs{};
  Eigen::MatrixXd normal_matrix{};  ///< sum over the runs
  std::vector<char> at_bound{};     ///< for each parameter whether it is at a physical bound
  /// All residuals, those of the priors of initial states included, and their derivatives with respect to the
  /// parameters, projected on what the initial states cannot absorb.
  Eigen::VectorXd stacked_residuals{};
  Eigen::MatrixXd jacobian{};
  /// For each block of residuals an orthonormal basis of what its initial state can absorb.
  std::vector<Eigen::MatrixXd> initial_state_bases{};
  [[nodiscard]] std::size_t samples() const;
};

/// Bounded least squares of a hypothesis over all runs by Ceres; free initial states of windows are fitted along.
/// Derivatives by forward differences, in parallel; the result does not depend on the number of threads. Nothing if the
/// model at the start cannot be simulated.
[[nodiscard]] Counted<std::optional<Fit>> fit(const FitRequest& request);

/// Residuals at the given parameters, only the initial states being fitted; derivatives with respect to the parameters
/// are zero. Nothing if the model cannot be simulated.
[[nodiscard]] Counted<std::optional<Fit>> evaluate_at(const FitRequest& request);

/// As evaluate_at(), with the derivatives with respect to the parameters.
[[nodiscard]] Counted<std::optional<Fit>> evaluate_with_jacobian(const FitRequest& request);

/// The residuals of a fit as whiteness tests take them: one series per channel of each run.
[[nodiscard]] std::vector<whiteness::ScaledResidual> scaled_residuals(std::span<const replay::PreparedRun> runs,
                                                                      const Fit& fit);

}  // namespace coilwright::measurement::fit
