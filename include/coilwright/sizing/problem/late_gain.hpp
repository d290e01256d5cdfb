#pragma once

#include <cstddef>
#include <optional>

#include "coilwright/sizing/problem/archive.hpp"

namespace coilwright::sizing {

/// Improvement by the last fifth of a search's designs over those before them, dimensionless, >= 0: for a front the
/// share of its normalised hypervolume (between the end's own ideal and nadir), for one objective the change of the
/// best value over the magnitude of the first one. A search that was cut short can probably gain about as much or more;
/// a small gain does not prove that nothing is left.
///
/// Designs count by their numbers from 1 to `evaluations`. Absent if the first four fifths have no feasible design.
[[nodiscard]] std::optional<double> late_gain(const Archive& archive, std::size_t evaluations);

}  // namespace coilwright::sizing
