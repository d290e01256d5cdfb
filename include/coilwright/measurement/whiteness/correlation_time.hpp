#pragma once

#include <span>

#include "coilwright/measurement/whiteness/scaled_residual.hpp"

namespace coilwright::measurement::whiteness {

/// How many samples of the residuals count as one: the integrated autocorrelation time 1 + 2 sum rho(t) about zero
/// mean, in samples, >= 1, summed up to the first lag that is five times the sum so far (Sokal's window). Products
/// across the start of a window do not count. 1 for white noise; throws as `adequacy_of` does.
[[nodiscard]] double correlation_time(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement::whiteness
