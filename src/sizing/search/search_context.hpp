#pragma once

#include <cstddef>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "sizing/problem/workers.hpp"
#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// What a search works with.
struct SearchContext {
  Archive& archive;              ///< evaluates and records every design
  Samples& samples;              ///< what is known at the start; learns every design
  Workers& workers;              ///< evaluates designs and optimises models at the same time
  const SearchOptions& options;  ///< algorithm, seed, stop and progress
  std::size_t budget;            ///< largest number of new designs
};

/// Tells `options.progress`, if there is one, how far the search has come.
void report_progress(const SearchContext& context);

}  // namespace coilwright::sizing
