#pragma once

#include <numbers>

/// An angle of one degree, rad: `30.0 * degree` is an angle. For every test program, and what they share.
inline constexpr double degree = std::numbers::pi / 180.0;
/// An angle of one radian, degrees.
inline constexpr double radian_in_degrees = 180.0 / std::numbers::pi;
