#pragma once

#include "coilwright/sizing/problem/options.hpp"
#include "sizing/search/search_context.hpp"

namespace coilwright::sizing {

/// Searches for the front (for one objective, the best design) with models of the samples, in rounds of a fixed number
/// of designs. Each round proposes designs from everything that is known, evaluates them in parallel and learns them in
/// the order of proposal, so the number of threads changes nothing but the time. Where `options.algorithm` is not
/// `automatic`, that NLopt algorithm pursues the same goals on the problem itself. See docs/theory/sizing.md.
[[nodiscard]] StopReason surrogate_search(const SearchContext& context);

}  // namespace coilwright::sizing
