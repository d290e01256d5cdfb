#pragma once

#include <iosfwd>
#include <vector>

#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driven_motion.hpp"
#include "coilwright/systems/warm_up.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A driven actuator, as `drive --json` prints it. Keys end in their unit; warnings are words.
[[nodiscard]] text::Json to_json(const systems::DrivenActuator& driven);

/// A driven motion, as `drive --motion-s --json` prints it under "motion".
[[nodiscard]] text::Json to_json(const systems::MotionSummary& motion);

/// Writes the motion's samples as CSV, with the units at the ends of the columns: time, joint angles, bending angle and
/// speed, the current of each coil, that of the driver and its mean since the row before, and the energies.
void write_motion(std::ostream& out, const std::vector<systems::MotionSample>& motion);

/// The warming of a driven actuator, as `drive --warm-up-s --json` prints it under "warm_up": its first and last
/// sample, and the first part to pass its limit or null.
[[nodiscard]] text::Json to_json(const systems::WarmUp& warm_up);

/// Writes the samples of the warming as CSV: time, the mean temperature of each coil, the hottest place of the coils,
/// the warmest magnet, the resistance that the driver sees, currents of the coil that carries most, the current of the
/// supply, and the coils' heat.
void write_warm_up(std::ostream& out, const systems::WarmUp& warm_up);

}  // namespace coilwright::formats
