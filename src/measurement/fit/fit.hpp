#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/measurement/whiteness/whiteness_test.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::fit {

/// How a fit reads: residual of every run over its noise, and what their slopes say of the parameters.
struct RunFit {
  Eigen::VectorXd residuals{};    ///< (measured - predicted) / sigma: window after window, channel after channel
  Eigen::VectorXd predictions{};  ///< SI, in the same order
  /// Normal equations of this run with the start of each window eliminated: (p, p) and (p).
  Eigen::MatrixXd normal{};
  Eigen::VectorXd slope{};
  std::vector<simulation::State> starts{};  ///< of each window
};

/// A hypothesis fitted to all records.
struct Fit {
  Eigen::VectorXd values{};  ///< as Hypothesis::parameters
  double chi_square{};       ///< of all residuals
  std::vector<RunFit> runs{};
  Eigen::MatrixXd normal{};      ///< sum over the runs
  std::vector<char> at_bound{};  ///< per parameter: it ended at a physical bound
  /// All residuals one under the other, with the pull of free starts towards the measurement, and their slopes by the
  /// parameters with what the starts of their windows can absorb taken out; `start_bases` spans that, window by window.
  Eigen::VectorXd stacked{};
  Eigen::MatrixXd slopes{};
  std::vector<Eigen::MatrixXd> start_bases{};
  [[nodiscard]] std::size_t samples() const;
};

/// How long a fit may go on.
struct FitEffort {
  int iterations = 25;
  double tolerance = 1e-5;  ///< of the relative fall of chi^2 in a step
};

/// Bounded least squares of `hypothesis` over `records` by Ceres, from `start` (clamped to the bounds), free starts of
/// windows fitted along. Slopes by forward differences, in parallel; the answer does not depend on the threads.
/// `held`: a parameter kept at its value in `start`. Nothing where the model at `start` cannot be simulated.
struct FitRequest {
  const Hypothesis* hypothesis{};
  std::span<const replay::Record> records{};
  Eigen::VectorXd start{};
  const Fit* starts_from{};  ///< a fit whose window starts are taken over; null: from the measurement
  std::optional<Eigen::Index> held{};
  FitEffort effort{};
};
[[nodiscard]] std::optional<Fit> fit(const FitRequest& request);

/// Residuals at given values, only the starts of the windows being fitted; no slopes by the parameters (zero in the
/// answer). Nothing where the model cannot be simulated.
[[nodiscard]] std::optional<Fit> evaluate_at(const FitRequest& request);

/// As evaluate_at, with the slopes by the parameters.
[[nodiscard]] std::optional<Fit> evaluate_with_slopes(const FitRequest& request);

/// The residuals of a fit as tests of noise take them: a series a channel of a run.
[[nodiscard]] std::vector<whiteness::ScaledResidual> scaled_residuals(std::span<const replay::Record> records,
                                                                      const Fit& fit);

}  // namespace coilwright::measurement::fit
