#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/signals/scaled_residual.hpp"
#include "measurement/fit/fit_request.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::fit {

/// The residuals of one run over its noise, white where the model is right, and what their derivatives say of the
/// parameters.
struct RunFit {
  Eigen::VectorXd residuals{};    ///< replay::over_noise(measured - predicted): window after window, channel after
                                  ///< channel; 0 for a sample that is set aside
  Eigen::VectorXd predictions{};  ///< SI, in the same order
  /// Normal equations of this run, the local numbers of each window eliminated: matrix (p, p) and gradient (p).
  Eigen::MatrixXd normal_matrix{};
  Eigen::VectorXd gradient{};
  std::vector<std::vector<double>> local_numbers{};  ///< of each window, as replay::LocalNumbers orders them
};

/// A hypothesis fitted to all runs.
struct Fit {
  Eigen::VectorXd values{};   ///< of Hypothesis::parameters
  double chi_square{};        ///< sum of all squared residuals of the measurement
  double prior_chi_square{};  ///< sum of the squared distances of declared numbers, over their tolerances
  double model_error{1.0};    ///< PreparedRun::model_error of its runs
  double priors{};            ///< that sum and the same of all local numbers, weighed by the model error
  std::vector<RunFit> runs{};
  Eigen::MatrixXd normal_matrix{};  ///< sum over the runs, and of the prior
  std::vector<char> at_bound{};     ///< for each parameter whether it is at a physical bound
  /// All residuals block after block (a window, or a bench), each followed by those of the priors of its local numbers;
  /// at the end those of the prior of the parameters. Beside them their derivatives with respect to the parameters,
  /// projected on what the local numbers cannot absorb.
  Eigen::VectorXd stacked_residuals{};
  Eigen::MatrixXd jacobian{};
  /// For each block of residuals an orthonormal basis of what its local numbers can absorb.
  std::vector<Eigen::MatrixXd> local_bases{};
  /// For each block the derivatives with respect to the parameters and to its local numbers, nothing
  /// projected out.
  std::vector<Eigen::MatrixXd> parameter_columns{};
  std::vector<Eigen::MatrixXd> local_columns{};
  std::size_t used_samples{};  ///< samples that are not set aside
  /// What a fit makes smallest: the chi-squares of the measurement and of the weighed priors together.
  [[nodiscard]] double objective() const { return chi_square + priors; }
  [[nodiscard]] std::size_t samples() const { return used_samples; }
};

/// Bounded least squares of a hypothesis over all runs by Ceres; local numbers of windows are fitted along.
/// Derivatives by forward differences, in parallel; the result does not depend on the number of threads. Nothing if the
/// model at the start cannot be simulated.
[[nodiscard]] std::optional<Fit> fit(const FitRequest& request);

/// Residuals at the given parameters, only the local numbers being fitted; derivatives with respect to the parameters
/// are zero. Nothing if the model cannot be simulated.
[[nodiscard]] std::optional<Fit> evaluate_at(const FitRequest& request);

/// As evaluate_at(), with the derivatives with respect to the parameters.
[[nodiscard]] std::optional<Fit> evaluate_with_jacobian(const FitRequest& request);

/// The residuals of a fit as whiteness tests take them: one series per channel of each run.
[[nodiscard]] std::vector<signals::ScaledResidual> scaled_residuals(std::span<const replay::PreparedRun> runs,
                                                                    const Fit& fit);

}  // namespace coilwright::measurement::fit
