#pragma once

#include <string>

#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"

namespace coilwright::report {

/// How an actuator is driven, as tables, with a sentence for each warning.
[[nodiscard]] std::string to_text(const systems::DrivenActuator& driven, const systems::DriveQuestion& question);

/// A motion on that driver, as sentences.
[[nodiscard]] std::string to_text(const systems::MotionSummary& motion);

}  // namespace coilwright::report
