#pragma once

namespace coilwright::systems::rig {

/// What turning an angle from degrees (rad), or a height from millimetres (relative), may leave beyond a bound.
inline constexpr double rounding = 1e-8;

}  // namespace coilwright::systems::rig
