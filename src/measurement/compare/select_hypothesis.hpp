#pragma once

#include <vector>

#include "measurement/compare/hypothesis_search.hpp"

namespace coilwright::measurement::compare {

/// Fills `out`, whose first step and unit of evidence are there, from all hypotheses that were fitted: candidates best
/// first, and, where one gains decisively on the declared model, the steps to the simplest of those that come within a
/// decisive gain of the best, its rivals and the sets that cannot be told apart.
void choose(std::span<const replay::Record> records, std::vector<Scored> all, Attribution& out);

}  // namespace coilwright::measurement::compare
