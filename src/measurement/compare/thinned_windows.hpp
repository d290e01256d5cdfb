#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// The same runs with some of their windows: as many of each run as keep about SearchEffort::thinned_samples samples of
/// all runs together, at least SearchEffort::fewest_windows of a run, one at an uneven place in each block of equal
/// length, so that a period of the motion does not fall in step with them. Far from the noise a search ranks what
/// explains most of a large residual, which some windows show as well as all. Nothing where no run would lose any.
[[nodiscard]] std::optional<std::vector<replay::PreparedRun>> thinned(std::span<const replay::PreparedRun> runs);

/// Takes the best three of each size out of `all`, by quasi_bic() with that overdispersion, and leaves the others
/// there.
[[nodiscard]] std::vector<FittedHypothesis> split_off_the_best(std::vector<FittedHypothesis>& all,
                                                               double overdispersion);

/// Hypotheses that were fitted to some windows of `runs`, fitted to all of them from there. Those that cannot be
/// simulated on all windows are left out.
[[nodiscard]] fit::Counted<std::vector<FittedHypothesis>> on_all_windows(std::span<const replay::PreparedRun> runs,
                                                                         const std::vector<FittedHypothesis>& some);

}  // namespace coilwright::measurement::compare
