#pragma once

#include <span>

#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// The declared model without any effect, recalibrated: its declared numbers fitted from where they are, and from where
/// with_other_starts() begins (without faces that the finger may not have), and from the best of them with faces where
/// they leave less (from_reached_limits); the best of all. Throws std::runtime_error, which names the run, if it cannot
/// be simulated as it is declared.
[[nodiscard]] FittedHypothesis recalibrated(std::span<const replay::PreparedRun> runs,
                                            const replay::DeclaredModel& declared);

/// The same. Where the declared model leaves more than SearchEffort::weighs_model_error times the noise, the runs get
/// its model error, with which they keep on until it is that of what is left, and it is fitted with priors that weigh
/// as much against that.
[[nodiscard]] FittedHypothesis recalibrated_at_its_error(std::span<replay::PreparedRun> runs,
                                                         const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement::identification
