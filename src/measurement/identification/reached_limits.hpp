#pragma once

#include <span>
#include <vector>

#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {

/// The same hypothesis from where it was fitted, with one number moved to where it leaves less, all others kept: up to
/// three places, the lowest minima, for each declared number with a prior and another start
/// (CalibrationParameter::other_start). Such a number, the angle at which faces close, does nothing beyond a limit,
/// from where no derivative leads back to it, and a fit that begins before it runs into the wall with all its other
/// numbers. Places are looked at half a tolerance apart, from four tolerances before the declared number to twelve
/// behind it. Refers to `fitted`.
[[nodiscard]] std::vector<PlannedFit> from_reached_limits(std::span<const replay::PreparedRun> runs,
                                                          const FittedHypothesis& fitted);

}  // namespace coilwright::measurement::identification
