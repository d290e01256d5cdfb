#pragma once

#include <cstddef>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/sampling/unit_point.hpp"

namespace coilwright::sizing {

/// Unknown designs next to the sample at `index`: one grid step away in one variable, or with one categorical variable
/// at another level.
[[nodiscard]] std::vector<UnitPoint> unknown_neighbours(const Samples& samples, std::size_t index);

}  // namespace coilwright::sizing
