#pragma once

#include <span>

#include "coilwright/measurement/localise/residual_torque.hpp"

namespace coilwright::measurement::localise {

/// Throws std::invalid_argument naming run and rule if sizes do not match.
void validate_motions(std::span<const MeasuredMotion> motions, const actuator::Model& model);

}  // namespace coilwright::measurement::localise
