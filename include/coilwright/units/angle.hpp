#pragma once

#include <numbers>

namespace coilwright::units {

/// One degree, in radians: `5.0 * units::degree` is an angle of 5 degrees.
inline constexpr double degree = std::numbers::pi / 180.0;

/// Degrees per radian: `angle * units::degrees_per_radian` is the angle in degrees. Numbers under a name with a unit go
/// through from_si() instead, which gives back the decimal that was read.
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

}  // namespace coilwright::units
