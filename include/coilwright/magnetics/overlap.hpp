#pragma once

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// Whether two bodies are in the same place, as no two parts can be, the second one in `pose` seen from the first. By
/// points on and in each, 2.5 degrees and a 48th of a length apart: what overlaps by less than a thousandth of
/// the smaller body's size, or between such points, may not be seen. Precondition: a pose as wrench() takes it.
[[nodiscard]] bool overlap(const Shape& first, const Shape& second, const Pose& pose);

/// The same of two bodies where they are.
[[nodiscard]] bool overlap(const Body& first, const Body& second);

}  // namespace coilwright::magnetics
