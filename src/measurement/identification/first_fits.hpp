#pragma once

#include <functional>
#include <span>
#include <vector>

#include "coilwright/measurement/identification/posterior.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/identification/hypothesis_extension.hpp"

namespace coilwright::measurement::identification {

/// The first fits of planned hypotheses.
struct FirstFits {
  std::vector<FittedHypothesis> fits{};  ///< one of each hypothesis and set of discrete choices
  std::vector<RuledOut> failed{};        ///< hypotheses that leave the model from every start, and why
};

/// A short fit of each of `planned`, from its starts with each set of discrete choices; and from other starts
/// (from_other_starts); where one of them explains most of what is above the noise, only those whose screening
/// promises a part of that (SearchEffort::worth_more_runs), or that are worse than without the effect. `progress` is
/// told how many are done; it may be called from several threads, one at a time.
[[nodiscard]] FirstFits first_fits(std::span<const replay::PreparedRun> runs,
                                   const std::vector<PlannedExtension>& planned,
                                   const std::function<void(std::size_t)>& progress);

}  // namespace coilwright::measurement::identification
