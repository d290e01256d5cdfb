#pragma once

#include <span>
#include <string_view>

namespace coilwright::mechanics {

/// A castable silicone as its maker sells it. Sources: docs/theory/actuator.md, "Silicones".
struct SiliconeGrade {
  std::string_view name;  ///< "Ecoflex 00-30"
  double shore_a{};       ///< as the maker states it; 0 where it is Shore 00
  double shore_00{};      ///< likewise; 0 where it is Shore A
  /// At small strains, Pa: of the maker's stress at 100 % or by Gent of the hardness, where a factor of two is no
  /// surprise. See young_modulus_from_100_percent().
  double young_modulus{};
  double density{};            ///< kg/m^3
  double base_per_hardener{};  ///< mass of part A over that of part B; > 0
};

/// Every silicone of the table, by series and then by hardness. Lives as long as the program.
[[nodiscard]] std::span<const SiliconeGrade> silicone_grades() noexcept;

/// Young's modulus at small strains of a rubber whose stress at an extension of 100 % (over the section at rest, "100 %
/// modulus" of data sheets, ASTM D412) is `stress`, Pa: 12/7 of it, by the neo-Hookean law stress = E/3 (lambda -
/// lambda^-2) at lambda = 2 (Treloar, The Physics of Rubber Elasticity). Measured factors are 1.70 to 1.79 for Ecoflex,
/// but 1.22 to 1.33 for Dragon Skin, where this is 29 to 41 % too much. A data sheet's stress is further off: castings
/// of Dragon Skin had 0.74 to 0.94 of it, of Ecoflex 0.27 to 0.49. In all, the moduli of the table are 1.5 to 2.4 times
/// what those tests have, Ecoflex 00-10's 3.6 times (Marechal et al., Soft Robotics Materials Database, 2020, grip to
/// grip, which reads too soft by a part of that; docs/theory/actuator.md). Measure where it matters.
[[nodiscard]] constexpr double young_modulus_from_100_percent(double stress) noexcept {
  return stress * 12.0 / 7.0;
}

}  // namespace coilwright::mechanics
