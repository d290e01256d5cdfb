#pragma once

#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// Searches with the algorithm `options` name into an empty archive. Throws std::invalid_argument on max_evaluations 0.
[[nodiscard]] StopReason run_search(Archive& archive, const SearchOptions& options);

/// What keeps a design from being feasible: its failure, or the constraints above 0, worst first.
[[nodiscard]] std::vector<std::string> violated_by(const Problem& problem, const Evaluation& evaluation);

}  // namespace coilwright::sizing
