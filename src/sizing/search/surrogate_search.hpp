#pragma once

#include <cstddef>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "sizing/problem/workers.hpp"
#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// What the model-based search works with.
struct EngineRun {
  Archive& archive;              ///< receives every design
  Samples& samples;              ///< what is known at the start, and, afterwards, at the end
  Workers& workers;              ///< evaluates, and optimises models
  const SearchOptions& options;  ///< seed, stop, progress
  std::size_t budget;            ///< new designs at most
};

/// Model-based search for the front (for one objective: the best design) in rounds of a fixed number of designs: each
/// round looks at everything known, proposes, evaluates in parallel, learns in the order of proposal. The number of
/// threads therefore changes nothing but the time. See docs/theory/sizing.md.
[[nodiscard]] StopReason run_engine(const EngineRun& run);

}  // namespace coilwright::sizing
