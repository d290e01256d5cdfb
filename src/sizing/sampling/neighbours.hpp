#pragma once

#include <cstddef>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/infill.hpp"

namespace coilwright::sizing {

/// Designs one grid step away from a sample in one variable, or with another combination of levels that differs in one
/// categorical; only those not known yet.
[[nodiscard]] std::vector<Candidate> unknown_neighbours(const Samples& samples, std::size_t of);

}  // namespace coilwright::sizing
