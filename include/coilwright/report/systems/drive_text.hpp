#pragma once

#include <string>

#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"
#include "coilwright/systems/warm_up.hpp"

namespace coilwright::report {

/// How an actuator is driven, as tables, with a sentence for each warning.
[[nodiscard]] std::string to_text(const systems::DrivenActuator& driven, const systems::DriveQuestion& question);

/// A motion on that driver, as sentences.
[[nodiscard]] std::string to_text(const systems::MotionSummary& motion);

/// How it warms under that drive, as sentences.
[[nodiscard]] std::string to_text(const systems::WarmUp& warm_up);

}  // namespace coilwright::report
