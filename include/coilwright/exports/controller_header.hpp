#pragma once

#include <string>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/control/reach.hpp"

namespace coilwright::exports {

/// Throws std::invalid_argument where the model has what the header cannot say: effects, a torque correction, magnets
/// and coils that act on each other across more than one joint.
void require_header_can_say(const actuator::Model& model);

/// A C99 header for a microcontroller, nothing but <tgmath.h>: the profile, cw_profile_current(t), and the model,
/// cw_accelerations() and cw_step() (Runge and Kutta, fourth order) in float, or whatever CW_REAL is. Torques per
/// ampere are tables of 129 angles, linear between them; the header says how far they are from the curves. Throws as
/// require_header_can_say() does.
[[nodiscard]] std::string controller_header(const actuator::Model& model, const control::ProfileQuality& profile);

}  // namespace coilwright::exports
