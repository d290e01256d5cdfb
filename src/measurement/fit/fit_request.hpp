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
  int iterations = 25;
  double tolerance = 1e-5;  ///< relative fall of chi-square in one step
};

/// A hypothesis to be fitted to all runs. Refers to hypothesis, runs and the other fit.
struct FitRequest {
  const Hypothesis* hypothesis{};
  std::span<const replay::PreparedRun> runs{};
  Eigen::VectorXd start{};          ///< parameters, clamped to their bounds
  const Fit* local_numbers_from{};  ///< a fit whose local numbers the windows take over; null: the priors
  /// A fit of another hypothesis to the same runs, whose derivatives with respect to the declared numbers within their
  /// tolerances serve here too; null: they are taken here.
  const Fit* nominal_columns_from{};
  std::optional<Eigen::Index> held_parameter{};  ///< index of a parameter that keeps its value in `start`
  FitEffort effort{};
};

}  // namespace coilwright::measurement::fit
