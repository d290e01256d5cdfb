#pragma once

namespace coilwright::actuator {

/// Values beyond which a slip of the unit or of the decimal point is likelier than hardware.
///@{
inline constexpr double most_remanence = 2.0;  ///< T; sintered NdFeB has up to 1.5
inline constexpr double most_gravity = 100.0;  ///< m/s^2; 9.81 as mm/s^2 is 9810
///@}

}  // namespace coilwright::actuator
