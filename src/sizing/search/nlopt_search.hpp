#pragma once

#include "coilwright/sizing/problem/options.hpp"
#include "sizing/search/search_context.hpp"

namespace coilwright::sizing {

/// Searches for the best design with the NLopt algorithm that `options` names. First Sobol points in each combination
/// of levels; then one run from the best of each combination, in rounds of equal budget after each of which the better
/// half goes on (successive halving); last the grid neighbours of the best design. For one objective.
[[nodiscard]] StopReason nlopt_search(const SearchContext& context);

}  // namespace coilwright::sizing
