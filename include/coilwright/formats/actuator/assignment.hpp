#pragma once

#include <string_view>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::formats {

/// `design` with one number or the configuration set as an argument says, "gap_mm=1.2", "configuration=C" or, of an
/// effect that it has, "dry_friction.torque_Nmm=0.5". Names and units are those of a study's variables and spread;
/// calibration factors stay. Throws InputError whose file is the assignment: `gap_mm=-1: must be > 0 and <= 1000000`.
[[nodiscard]] actuator::Design with_assignment(actuator::Design design, std::string_view assignment);

}  // namespace coilwright::formats
