#pragma once

#include <optional>
#include <span>

#include "coilwright/measurement/planning/next_experiment.hpp"
#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::planning {

/// Of the candidate experiments the one on which the selected hypothesis and its rivals differ most: the largest value
/// of the smallest rms difference between any two of their predictions, over the noise of the first angle channel.
/// Nothing if there are no rivals, or no candidate separates them by half the noise.
[[nodiscard]] std::optional<NextExperiment> separating_experiment(std::span<const replay::PreparedRun> runs,
                                                                  const identification::Attribution& attribution);

}  // namespace coilwright::measurement::planning
