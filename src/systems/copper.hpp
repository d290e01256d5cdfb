#pragma once

namespace coilwright::systems {

inline constexpr double copper_melts = 1085.0;  ///< degC, CRC Handbook

}  // namespace coilwright::systems
