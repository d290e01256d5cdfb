#pragma once

#include <vector>

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// The fit runs without channels that are stuck: at least 20 samples, all of one value, while the input moves. Such a
/// record has no noise to weigh it by and would outweigh all others. A warning for each; a run without any channel left
/// is left out. Throws std::invalid_argument where no run is left.
[[nodiscard]] std::vector<Run> usable_runs(const std::vector<Run>& runs, std::vector<Warning>& warnings);

}  // namespace coilwright::measurement::data
