#pragma once

#include <span>

#include "coilwright/measurement/signals/scaled_residual.hpp"

namespace coilwright::measurement::signals {

/// The integrated autocorrelation time of the residuals about zero mean, 1 + 2 sum rho(t), in samples; >= 1, and 1 for
/// white noise: so many samples carry the information of one independent sample. The sum ends at the first lag that is
/// five times the sum so far (Sokal's window). Products across the start of a window do not count.
/// Throws as whiteness_test() does.
[[nodiscard]] double correlation_time(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement::signals
