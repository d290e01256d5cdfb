#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/simulation/commanded_input.hpp"
#include "coilwright/simulation/model_input.hpp"

namespace coilwright::formats {

/// Reads the time and input columns of a transient run of measured-data/1: `time_s` and one of `current_A`,
/// `current1_A,...`, `voltage_V`, `torque1_Nm,...`; at least one sample. Measured columns (`bending_angle_deg`,
/// `theta1_deg`, `omega1_rad_s`, ...) may stand beside them and are not used. Throws InputError.
[[nodiscard]] simulation::CommandedInput read_commanded_input(const std::filesystem::path& path);

/// Parses a commanded input from a text in memory; errors call it `file`.
[[nodiscard]] simulation::CommandedInput parse_commanded_input(std::string_view text, std::string_view file);

/// Throws InputError of `file` for a current that no coil carries, such as milliamperes taken for amperes. `coil` is
/// that of a design.
void require_bearable(const simulation::CommandedInput& command, const simulation::ModelInput& input,
                      const std::optional<actuator::CoilElectrics>& coil, const std::string& file);

}  // namespace coilwright::formats
