#pragma once

#include <vector>

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// Runs that a fit can use, and a warning for each channel that was left out.
struct UsableRuns {
  std::vector<Run> runs{};
  std::vector<Warning> warnings{};
};

/// The fit runs without channels that are stuck: at least 20 samples, all of one value, while the input changes. Such a
/// channel has no noise by which to weight it and would outweigh all others. A run that has no other channel is left
/// out. Throws std::invalid_argument if no run is left.
[[nodiscard]] UsableRuns usable_runs(const std::vector<Run>& runs);

}  // namespace coilwright::measurement::data
