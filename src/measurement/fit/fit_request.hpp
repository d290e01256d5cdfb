#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "measurement/fit/hypothesis.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::fit {

struct Fit;

/// When a fit ends.
struct FitEffort {
  int iterations = 25;      ///< at most; 0: residuals and derivatives are taken at the start, and nothing is moved
  double tolerance = 1e-5;  ///< relative fall of chi-square in one step
};

/// A hypothesis to be fitted to all runs. Refers to hypothesis, runs and the other fit.
struct FitRequest {
  const Hypothesis* hypothesis{};
  std::span<const replay::PreparedRun> runs{};
  Eigen::VectorXd start{};          ///< parameters, clamped to their bounds
  const Fit* local_numbers_from{};  ///< a fit whose local numbers the windows take over; null: the priors
  /// A fit to the same runs whose derivatives with respect to declared numbers within their tolerances, and to local
  /// numbers that move the model, serve here too: they change little from one hypothesis to the next and cost most of a
  /// fit's simulated runs. Null: all are taken here, at each step. Residuals are always those of the numbers
  /// themselves.
  const Fit* derivatives_from{};
  /// Derivatives are taken once, where the fit begins; from step to step they are only corrected by what the step has
  /// shown of them, which costs no simulated run. False: they are taken anew at each step.
  bool updates_derivatives{};
  std::optional<Eigen::Index> held_parameter{};  ///< index of a parameter that keeps its value in `start`
  FitEffort effort{};
};

}  // namespace coilwright::measurement::fit
