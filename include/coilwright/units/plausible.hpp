#pragma once

#include "coilwright/units/unit.hpp"

namespace coilwright::units {

/// Largest plausible magnitude, in `unit`, of a number of an actuator, its surroundings or a measurement: far beyond
/// any hardware, and small enough that nothing overflows. Larger numbers are slips.
[[nodiscard]] double greatest_plausible(const Unit& unit) noexcept;

}  // namespace coilwright::units
