#pragma once

namespace coilwright::winding {

/// Resistivity of annealed copper at 20 degC, ohm m: 100 % IACS, IEC 60028:1925 (1/58 ohm mm2/m).
inline constexpr double copper_resistivity = 1.7241e-8;

/// Temperature coefficient of resistance of annealed copper about 20 degC, 1/K (IEC 60028:1925).
inline constexpr double copper_temperature_coefficient = 3.93e-3;

/// Density of copper, kg/m3. IEC 60028 gives 8890 for hard-drawn and annealed conductors at 20 degC; pure wrought
/// copper has 8960 (CRC Handbook), with which the prototype's masses were checked (0.8 % more).
inline constexpr double copper_density = 8960.0;

/// Ratio of a copper resistance at `temperature` (degC, above absolute zero) to its value at 20 degC.
///
/// Linear law R = R20 (1 + a (T - 20)), IEC 60028. Copper follows it to about 0.5 % between -50 and 200 degC, the range
/// of enamelled wire; it does not hold below (residual resistance) or near melting. Throws std::invalid_argument for a
/// temperature that is not finite or so low that the law is not positive.
[[nodiscard]] double copper_resistance_ratio(double temperature);

}  // namespace coilwright::winding
