#pragma once

#include <span>
#include <string_view>

namespace coilwright::mechanics {

/// A castable silicone as its maker sells it. Sources: docs/theory/actuator.md, "Silicones".
struct SiliconeGrade {
  std::string_view name;  ///< "Ecoflex 00-30"
  double shore_a{};       ///< Shore A as the maker states it; 0 if that is Shore 00
  double shore_00{};      ///< Shore 00 as the maker states it; 0 if that is Shore A
  /// Young's modulus at small strains, Pa: from the maker's stress at 100 % or from the hardness by Gent. An error of a
  /// factor of two is not unusual. See young_modulus_from_100_percent().
  double young_modulus{};
  double density{};            ///< kg/m^3
  double base_per_hardener{};  ///< mass of part A over that of part B; > 0
};

/// Every silicone of the table, by series and then by hardness. The table lives as long as the program.
[[nodiscard]] std::span<const SiliconeGrade> silicone_grades() noexcept;

/// Young's modulus at small strains of a rubber whose stress at an extension of 100 % is `stress`, Pa (over the section
/// at rest; the "100 % modulus" of data sheets, ASTM D412): 12/7 of it, by the neo-Hookean law stress = E/3 (lambda -
/// lambda^-2) at lambda = 2 (Treloar, The Physics of Rubber Elasticity).
///
/// Measured factors are 1.70 to 1.79 for Ecoflex, and 1.22 to 1.33 for Dragon Skin, for which the law is 29 to 41 % too
/// high. A data sheet's stress is further off: castings of Dragon Skin had 0.74 to 0.94 of it, of Ecoflex 0.27 to 0.49.
/// Together the moduli of the table are 1.5 to 2.4 times those of the tests, 3.6 times for Ecoflex 00-10 (Marechal et
/// al., Soft Robotics Materials Database, 2020, grip to grip, which reads somewhat too soft; docs/theory/actuator.md).
/// Measure it if it matters.
[[nodiscard]] constexpr double young_modulus_from_100_percent(double stress) noexcept {
  return stress * 12.0 / 7.0;
}

}  // namespace coilwright::mechanics
