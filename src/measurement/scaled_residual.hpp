#pragma once

#include <span>

#include "coilwright/measurement/adequacy.hpp"

namespace coilwright::measurement {

/// Throws std::invalid_argument naming run and rule.
void check(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement
