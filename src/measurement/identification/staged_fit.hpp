#pragma once

#include <optional>
#include <span>

#include "measurement/identification/fit_in_turns.hpp"

namespace coilwright::measurement::identification {

/// The best fit from there; its derivatives are those of where it ended. Nothing if the model cannot be simulated.
[[nodiscard]] std::optional<FittedHypothesis> fit_to_its_end(std::span<const replay::PreparedRun> runs,
                                                             const PlannedFit& plan, const fit::FitEffort& effort);
/// The same with SearchEffort::exact: for a hypothesis whose numbers are reported.
[[nodiscard]] std::optional<FittedHypothesis> fit_exactly(std::span<const replay::PreparedRun> runs,
                                                          const PlannedFit& plan);

/// `base` at its fit with additional effects, each with the given numbers. Refers to `base`.
[[nodiscard]] PlannedFit with_added_effects(const FittedHypothesis& base, std::span<const actuator::Effect> added);

/// The declared model at its declared numbers, for PlannedFit::derivatives_from of fits that start there: with an
/// effect as weak as it starts they are much the same. Nothing where derivatives cost little, and where there is no
/// motion.
[[nodiscard]] std::optional<fit::Fit> at_declared_numbers(std::span<const replay::PreparedRun> runs,
                                                          const replay::DeclaredModel& declared);

/// `effort` for hypotheses that add to `known`, its tolerance taken as a fraction of what `known` leaves above the
/// noise, not of the whole of chi-square: near the noise a hundredth of that is a hundred times what decides. A step
/// that gains less than what decides nothing (DecisionThresholds::decisive_gain) ends the fit in any case.
[[nodiscard]] fit::FitEffort ends_by_what_is_left(fit::FitEffort effort, const FittedHypothesis& known);

/// The result of a fit that ended after a few iterations.
struct ShortFit {
  PlannedFit plan;  ///< where it started
  fit::Fit fitted{};
};
/// Best result of a short fit from each of several guesses, each a set of effects that are added to `base` together.
/// Nothing if none of them can be simulated. Refers to `base`.
[[nodiscard]] std::optional<ShortFit> short_fit(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                                std::span<const std::vector<actuator::Effect>> guesses);

/// Whether a base with effects added has no fit, or one that is decisively worse than the base, which has no more
/// freedom: then it has not come near its optimum. Never where the base is far from the noise, where that makes no
/// answer right.
[[nodiscard]] bool is_worse_than(const FittedHypothesis& base, const std::optional<ShortFit>& larger);

/// The best of `so_far` and of fits from elsewhere: from the declared numbers where `base` has no effect and its
/// declared numbers are far off. Where the best then ends with a number of an effect at its bound, or explains next to
/// nothing of what is above the noise, from the declared numbers with each of `further` too, unless `base` leaves noise
/// or is very far from it (SearchEffort). Where it is no better than `base`, from guesses that are next to absent.
/// `at_declared` has derivatives for fits from there; null: they take their own. Refers to `base`.
[[nodiscard]] std::optional<ShortFit> from_other_starts(std::span<const replay::PreparedRun> runs,
                                                        const FittedHypothesis& base,
                                                        std::span<const std::vector<actuator::Effect>> guesses,
                                                        std::span<const std::vector<actuator::Effect>> further,
                                                        const fit::Fit* at_declared, std::optional<ShortFit> so_far);

}  // namespace coilwright::measurement::identification
