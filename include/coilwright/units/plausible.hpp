#pragma once

#include "coilwright/units/unit.hpp"

namespace coilwright::units {

/// The greatest size, in `unit` and without its sign, that a number of an actuator, its surroundings or a measurement
/// can have: far beyond any hardware, and near enough that nothing overflows. What is larger is a slip.
[[nodiscard]] double greatest_plausible(const Unit& unit) noexcept;

}  // namespace coilwright::units
