#pragma once

#include <iosfwd>
#include <vector>

#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A driven actuator, as `drive --json` prints it. Keys end in their unit; warnings are words.
[[nodiscard]] text::Json to_json(const systems::DrivenActuator& driven);

/// A driven motion, as `drive --motion-s --json` prints it under "motion".
[[nodiscard]] text::Json to_json(const systems::MotionSummary& motion);

/// The motion's samples as CSV, the keys' units at the ends of the columns: time, joint angles, bending angle and
/// speed, the current of each coil, that of the driver and its mean since the row before, and where the energy has
/// gone.
void write_motion(std::ostream& out, const std::vector<systems::MotionSample>& motion);

}  // namespace coilwright::formats
