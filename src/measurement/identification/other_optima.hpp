#pragma once

#include <cstdint>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {

/// From the declared numbers, with these effects in place of those of `fitted`.
[[nodiscard]] PlannedFit from_declared_numbers(const FittedHypothesis& fitted, std::vector<actuator::Effect> effects);

/// The same effects with one of their discrete choices (a side, a warm start) changed: the choice that is better for an
/// effect alone may not be better in combination. Refers to `fitted`.
[[nodiscard]] std::vector<PlannedFit> with_other_choices(const FittedHypothesis& fitted);

/// The same hypothesis from other starts, since the sum of squares has other local optima: from the declared numbers
/// and the priors of the local numbers, with the effects as they are, weaker, and (those of several numbers) scattered
/// at random; and with each declared number that has another start there (CalibrationParameter::other_start). Refers to
/// `fitted`.
[[nodiscard]] std::vector<PlannedFit> with_other_starts(const FittedHypothesis& fitted, std::uint64_t seed);

/// Of a hypothesis with one effect of several numbers: the same from the declared numbers and from each start of the
/// effect's own, as strong as that is. What a linearisation at the recalibrated model predicts of an attraction's
/// strength, range and side leads away from the right one where declared numbers have been pulled far. Empty for
/// others.
[[nodiscard]] std::vector<PlannedFit> from_own_starts(const FittedHypothesis& fitted, const actuator::RigScale& scale);

/// The same hypothesis with further numbers of one of its effects (EffectKind::with_further_numbers), from each of
/// their starts: with the numbers that were fitted, and, near the noise, with those of the start too. Refers to
/// `fitted`.
[[nodiscard]] std::vector<PlannedFit> with_further_numbers(const FittedHypothesis& fitted,
                                                           const actuator::RigScale& scale);

}  // namespace coilwright::measurement::identification
