#pragma once

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// Whether two bodies occupy the same place; `pose` is that of the second one seen from the first. The test takes
/// points on and in each body, 2.5 degrees and a 48th of a length apart, so it may miss an overlap of less than a
/// thousandth of the smaller body's size, or between such points. Precondition: a pose as wrench() takes it.
[[nodiscard]] bool overlap(const Shape& first, const Shape& second, const Pose& pose);

/// The same test for two bodies at their own poses.
[[nodiscard]] bool overlap(const Body& first, const Body& second);

}  // namespace coilwright::magnetics
