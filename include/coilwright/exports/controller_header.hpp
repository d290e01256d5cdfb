#pragma once

#include <string>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/control/reach.hpp"

namespace coilwright::exports {

/// Throws std::invalid_argument if the model has something that the header cannot express: effects, a torque
/// correction, magnets and coils that act on each other across more than one joint.
void require_header_can_say(const actuator::Model& model);

/// Writes a C99 header for a microcontroller that needs only <tgmath.h>: the profile, cw_profile_current(t), and the
/// model, cw_accelerations() and cw_step() (Runge and Kutta, fourth order) in float, or in CW_REAL. Torques per ampere
/// are tables of 129 angles, linear between them; the header states their error. Throws as require_header_can_say()
/// does.
[[nodiscard]] std::string controller_header(const actuator::Model& model, const control::ProfileQuality& profile);

}  // namespace coilwright::exports
