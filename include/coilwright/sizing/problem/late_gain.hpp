#pragma once

#include <cstddef>
#include <optional>

#include "coilwright/sizing/problem/archive.hpp"

namespace coilwright::sizing {

/// By how much the last fifth of a search's designs improved what was found before them: of a front the share of its
/// normalised hypervolume (between the end's own ideal and nadir), of one objective the change of the best value over
/// the magnitude of the first one; dimensionless, >= 0. What a search that was cut short has left to find is likely of
/// that order or more; a small gain does not prove that nothing is left.
///
/// Designs count by their numbers from 1 to `evaluations`. Nothing where the first four fifths have no feasible design.
[[nodiscard]] std::optional<double> late_gain(const Archive& archive, std::size_t evaluations);

}  // namespace coilwright::sizing
