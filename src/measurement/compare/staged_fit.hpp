#pragma once

#include <optional>
#include <span>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// A hypothesis to be fitted and the point at which its fit starts. Refers to the fit whose initial states it takes
/// over.
struct PlannedFit {
  fit::Hypothesis hypothesis;
  Eigen::VectorXd start{};
  const fit::Fit* local_numbers_from{};  ///< null: from the measurement
  /// Whether the derivatives with respect to declared numbers within their tolerances are those of that fit.
  bool known_columns = true;
};
/// Refers to `plan`.
[[nodiscard]] fit::FitRequest fit_request_of(std::span<const replay::PreparedRun> runs, const PlannedFit& plan);
/// Nothing if the model cannot be simulated.
[[nodiscard]] fit::Counted<std::optional<FittedHypothesis>> fit_to_convergence(
    std::span<const replay::PreparedRun> runs, const PlannedFit& plan);

/// `base` at its fit with additional effects, each with the given numbers. Refers to `base`.
[[nodiscard]] PlannedFit with_added_effects(const FittedHypothesis& base, std::span<const actuator::Effect> added);

/// The result of a fit that ended after a few iterations.
struct ShortFit {
  PlannedFit plan;  ///< where it started
  fit::Fit fitted{};
};
/// Best result of a short fit from each initial guess of one added effect. Nothing if none of them can be simulated.
/// Refers to `base`.
[[nodiscard]] fit::Counted<std::optional<ShortFit>> short_fit(std::span<const replay::PreparedRun> runs,
                                                              const FittedHypothesis& base,
                                                              std::span<const actuator::Effect> guesses);
/// Continues a short fit to convergence.
[[nodiscard]] fit::Counted<std::optional<FittedHypothesis>> refine(std::span<const replay::PreparedRun> runs,
                                                                   const ShortFit& from);

}  // namespace coilwright::measurement::compare
