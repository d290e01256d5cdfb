#pragma once

namespace coilwright::actuator {

/// Values beyond which a slip of the unit or of the decimal point is likelier than hardware.
///@{
inline constexpr double shortest_length = 5e-5;  ///< m, of a part; a file in metres has 0.02 for 20 mm
inline constexpr double longest_length = 1.0;    ///< m, of a part
inline constexpr double most_remanence = 2.0;    ///< T; sintered NdFeB has up to 1.5
/// T; of a lumped model, whose magnets stand for all that makes the torque stronger: a fit to an actuator with another
/// effect than those of the catalogue has found 2.007 T.
inline constexpr double most_effective_remanence = 5.0;
inline constexpr double coldest_ambient = -50.0;   ///< degC; below it copper's linear law and the silicone do not hold
inline constexpr double hottest_ambient = 200.0;   ///< degC; above it they do not hold
inline constexpr double least_coercivity = 10e3;   ///< A/m; AlNiCo has 40e3 and more
inline constexpr double most_coercivity = 5000e3;  ///< A/m; SmCo and NdFeB have up to 3000e3
inline constexpr double most_coefficient = 0.02;   ///< 1/K, either sign, of Br and HcJ; ferrites' HcJ has 0.003
inline constexpr double least_squareness = 0.6;
inline constexpr double most_squareness = 0.99;
inline constexpr double most_gravity = 100.0;  ///< m/s^2; 9.81 as mm/s^2 is 9810
///@}

}  // namespace coilwright::actuator
