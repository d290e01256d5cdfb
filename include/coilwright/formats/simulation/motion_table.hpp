#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "coilwright/simulation/commanded_input.hpp"
#include "coilwright/simulation/recorded_motion.hpp"

namespace coilwright::formats {

/// The columns of a command's input, as records name them: "current_A", "voltage_V", "torque1_Nm", ..
[[nodiscard]] std::vector<std::string> columns_of_input(const simulation::CommandedInput& command);

/// The columns of what `simulate` writes: time_s, the input, theta1_deg, .., bending_angle_deg, bending_speed_deg_s.
[[nodiscard]] std::vector<std::string> columns_of_motion(const simulation::CommandedInput& command, int joints);

/// One sample of a motion under `command`, in the units of columns_of_motion().
[[nodiscard]] std::vector<double> motion_row(const simulation::CommandedInput& command,
                                             const simulation::RecordedMotion& motion, std::size_t sample);

/// Writes the whole motion as CSV.
void write_motion(std::ostream& out, const simulation::CommandedInput& command,
                  const simulation::RecordedMotion& motion);

}  // namespace coilwright::formats
