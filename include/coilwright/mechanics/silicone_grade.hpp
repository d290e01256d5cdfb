#pragma once

#include <span>
#include <string_view>

namespace coilwright::mechanics {

/// A castable silicone as its maker sells it. Sources: docs/theory/actuator.md, "Silicones".
struct SiliconeGrade {
  std::string_view name;       ///< "Ecoflex 00-30"
  double shore_a{};            ///< as the maker states it; 0 where it is Shore 00
  double shore_00{};           ///< likewise; 0 where it is Shore A
  double young_modulus{};      ///< at small strains, Pa: see young_modulus_from_100_percent()
  double density{};            ///< kg/m^3
  double base_per_hardener{};  ///< mass of part A over that of part B; > 0
};

/// Every silicone of the table, by series and then by hardness. Lives as long as the program.
[[nodiscard]] std::span<const SiliconeGrade> silicone_grades() noexcept;

/// Young's modulus of a rubber whose stress at an extension of 100 % (over the section at rest, "100 % modulus" of data
/// sheets) is `stress`, Pa: 12/7 of it, by the neo-Hookean law stress = E/3 (lambda - lambda^-2) at lambda = 2
/// (Treloar, The Physics of Rubber Elasticity). Castable silicones soften and stiffen before that, so it is good to
/// about 30 %.
[[nodiscard]] constexpr double young_modulus_from_100_percent(double stress) noexcept {
  return stress * 12.0 / 7.0;
}

}  // namespace coilwright::mechanics
