#pragma once

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::data {

/// Time between two samples of a run where nothing is wrong, s: the median, as a clock that jumped once is no slow
/// camera. At least two samples.
[[nodiscard]] double median_interval(const Run& run);

}  // namespace coilwright::measurement::data
