#pragma once

#include <optional>
#include <span>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// A hypothesis to be fitted and the point at which its fit starts. Refers to the fits from which it takes local
/// numbers and derivatives.
struct PlannedFit {
  fit::Hypothesis hypothesis;
  Eigen::VectorXd start{};
  const fit::Fit* local_numbers_from{};  ///< null: from the measurement
  const fit::Fit* derivatives_from{};    ///< as fit::FitRequest has it; null: all are taken where it starts
};
/// Refers to `plan`.
[[nodiscard]] fit::FitRequest fit_request_of(std::span<const replay::PreparedRun> runs, const PlannedFit& plan);
/// The best fit from there; its derivatives are those of where it ended. Nothing if the model cannot be simulated.
[[nodiscard]] fit::Counted<std::optional<FittedHypothesis>> fit_to_convergence(
    std::span<const replay::PreparedRun> runs, const PlannedFit& plan);
/// The same to a tenth of its tolerance: for a hypothesis whose numbers are reported.
[[nodiscard]] fit::Counted<std::optional<FittedHypothesis>> fit_exactly(std::span<const replay::PreparedRun> runs,
                                                                        const PlannedFit& plan);

/// `base` at its fit with additional effects, each with the given numbers. Refers to `base`.
[[nodiscard]] PlannedFit with_added_effects(const FittedHypothesis& base, std::span<const actuator::Effect> added);

/// The result of a fit that ended after a few iterations.
struct ShortFit {
  PlannedFit plan;  ///< where it started
  fit::Fit fitted{};
};
/// Best result of a short fit from each of several guesses, each a set of effects that are added to `base` together;
/// tried from the declared numbers too where `base` has no effect and its declared numbers are far off. Nothing if none
/// of them can be simulated. Refers to `base`.
[[nodiscard]] fit::Counted<std::optional<ShortFit>> short_fit(std::span<const replay::PreparedRun> runs,
                                                              const FittedHypothesis& base,
                                                              std::span<const std::vector<actuator::Effect>> guesses);
/// Continues a short fit to convergence.
[[nodiscard]] fit::Counted<std::optional<FittedHypothesis>> refine(std::span<const replay::PreparedRun> runs,
                                                                   const ShortFit& from);

}  // namespace coilwright::measurement::compare
