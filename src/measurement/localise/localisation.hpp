#pragma once

#include <optional>
#include <span>

#include "coilwright/measurement/localise/residual_torque.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::localise {

/// The residual of a fitted hypothesis as a torque along the measured motion. Nothing if no run is a motion.
[[nodiscard]] std::optional<ResidualTorque> localise(std::span<const replay::PreparedRun> runs,
                                                     const identification::FittedHypothesis& fitted);

}  // namespace coilwright::measurement::localise
