#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coilwright/measurement/identification/posterior.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/identification/hypothesis_extension.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {

/// Fitted hypotheses with the same number of effects.
using HypothesesOfSize = std::vector<FittedHypothesis>;

/// Whether what one of a level leaves passes as noise.
[[nodiscard]] bool leaves_noise(const HypothesesOfSize& level);

/// The hypothesis of a level that is nearest to the data by its objective; nullptr in an empty level.
[[nodiscard]] const FittedHypothesis* nearest(const HypothesesOfSize& level);

/// Which of a level (in its order) are among the first `most` and worth more runs than they have had (see
/// SearchEffort::worth_more_runs). `of_the_size_before` is the least objective of the hypotheses with one effect less.
[[nodiscard]] std::vector<std::size_t> contenders(const HypothesesOfSize& level, double of_the_size_before,
                                                  std::size_t most);

/// The fits of planned hypotheses.
struct LevelFits {
  HypothesesOfSize level{};        ///< best of the short fits first
  std::vector<RuledOut> failed{};  ///< those that leave the model from every start, and why
};

/// A short fit of each of `planned`, from its starts with each set of discrete choices; those of the best `refined`
/// that are worth it are continued to convergence with each of these choices, and are what the best of them is.
/// `progress` is told how many are done, and the latest short fit if there is one; it may be called from several
/// threads, one at a time.
[[nodiscard]] LevelFits fit_level(std::span<const replay::PreparedRun> runs,
                                  const std::vector<PlannedExtension>& planned, std::size_t refined,
                                  const std::function<void(std::size_t, const ShortFit*)>& progress);

/// A level (sorted, best first) whose best hypotheses are where another start or another discrete choice leads if that
/// is better; and these with further numbers of their effects, which give those without them another start. One after
/// the other: once a hypothesis leaves noise, only near rivals are worth more runs. Far from the noise
/// (SearchEffort::near_the_noise) other starts race and an effect's own ones are left out. `of_the_size_before` as in
/// contenders(). `progress` is told which place of how many is tried.
[[nodiscard]] HypothesesOfSize with_better_optima(std::span<const replay::PreparedRun> runs, HypothesesOfSize level,
                                                  double of_the_size_before, const actuator::RigScale& scale,
                                                  std::uint64_t seed,
                                                  const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace coilwright::measurement::identification
