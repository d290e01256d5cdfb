#pragma once

#include <cstddef>
#include <vector>

#include "sizing/sampling/goal.hpp"
#include "sizing/sampling/samples.hpp"
#include "sizing/sampling/unit_point.hpp"
#include "sizing/surrogate/region.hpp"

namespace coilwright::sizing {

/// At most three unknown designs that the local model expects to reach the goal, best first: the optimum of the goal on
/// the model, found with NLopt, or on a grid the best unknown grid points near it. Empty if the model expects no
/// progress, except where the region holds a level: there the designs for which the model need be least wrong. Pure.
[[nodiscard]] std::vector<UnitPoint> infill(const Samples& samples, const Goal& goal, const Region& region);

/// At most `count` unknown designs next to the sample at `index`, two or three grid steps away at most: those that
/// would beat the goal with the smallest error of the model around that sample. Empty without a grid and in more than
/// ten dimensions. Pure.
[[nodiscard]] std::vector<UnitPoint> least_surprising_neighbours(const Samples& samples, const Goal& goal,
                                                                 std::size_t index, std::size_t count);

}  // namespace coilwright::sizing
