#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "measurement/identification/search_starts.hpp"

namespace coilwright::measurement::identification {

/// Is told how many fits begin.
using FitsBegin = std::function<void(std::size_t)>;

/// Continues those of the heaviest fits (SearchEffort::heaviest, by what they promise) that have not reached their
/// optima, and adds where they end to the table. False if there was none.
[[nodiscard]] bool continue_promising(HypothesisTable& table, const FitsBegin& begin);

/// Short fits from the lowest starts of each hypothesis. Those that may hold SearchEffort::least_weight come into the
/// table, unless they lead back to where their hypothesis has been. False if none did.
[[nodiscard]] bool fit_from(std::vector<Start> starts, HypothesisTable& table, const FitsBegin& begin);

}  // namespace coilwright::measurement::identification
