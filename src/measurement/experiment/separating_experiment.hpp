#pragma once

#include <optional>
#include <span>

#include "coilwright/measurement/experiment/next_experiment.hpp"
#include "measurement/compare/hypothesis_search.hpp"

namespace coilwright::measurement::experiment {

/// Of a menu of runs the one on which the fitted rivals differ most: the largest smallest rms difference between any
/// two of their predictions over the noise of the first angle channel. Nothing without rivals, or where no run shows a
/// difference of half the noise.
[[nodiscard]] std::optional<NextExperiment> next_experiment(std::span<const replay::Record> records,
                                                            const compare::Attribution& attribution);

}  // namespace coilwright::measurement::experiment
