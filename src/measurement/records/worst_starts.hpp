#pragma once

#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::records {

/// Whether what a model leaves of a motion that starts as it was measured is worst at the start: of the first 15
/// samples, through which the measured start is a parabola, at least three times the noise (rms) and three times what
/// it leaves of the rest. An input that jumps there bends the motion as no parabola does. `predictions` are of each
/// channel. Samples that are set aside do not count.
[[nodiscard]] bool is_worst_at_start(const replay::PreparedRun& prepared,
                                     std::span<const std::vector<double>> predictions);

/// What is said of such runs, under the name of the first; nothing where there are none.
[[nodiscard]] std::vector<data::Warning> worst_starts(std::span<const std::string> runs);

}  // namespace coilwright::measurement::records
