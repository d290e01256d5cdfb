#pragma once

#include <optional>
#include <span>

#include "coilwright/measurement/localise/residual_torque.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::localise {

/// The rest that a fitted hypothesis leaves, as a torque over the measured motion. Nothing where no run is a motion.
[[nodiscard]] std::optional<ResidualTorque> localise(std::span<const replay::Record> records,
                                                     const compare::Scored& fitted);

}  // namespace coilwright::measurement::localise
