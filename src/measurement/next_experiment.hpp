#pragma once

#include <optional>
#include <span>

#include "attribution.hpp"

namespace coilwright::measurement {

/// Of a menu of runs the one on which the fitted rivals differ most: the largest smallest rms difference between any
/// two of their predictions over the noise of the first angle channel. Nothing without rivals, or where no run shows a
/// difference of half the noise.
[[nodiscard]] std::optional<NextExperiment> next_experiment(std::span<const Record> records,
                                                            const Attribution& attribution);

}  // namespace coilwright::measurement
