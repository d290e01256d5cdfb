#pragma once

#include <string>

#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"
#include "coilwright/systems/warm_up.hpp"

namespace coilwright::report {

/// The answer of `drive` as tables, with a sentence for each warning.
[[nodiscard]] std::string to_text(const systems::DrivenActuator& driven, const systems::DriveQuestion& question);

/// The motion of a driven actuator, as sentences.
[[nodiscard]] std::string to_text(const systems::MotionSummary& motion);

/// The warming of a driven actuator, as sentences.
[[nodiscard]] std::string to_text(const systems::WarmUp& warm_up);

}  // namespace coilwright::report
