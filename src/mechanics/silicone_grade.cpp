#include "coilwright/mechanics/silicone_grade.hpp"

#include <array>

namespace coilwright::mechanics {
namespace {

constexpr double psi = 6894.757;  // Pa
constexpr double gram_per_cm3 = 1000.0;

struct Hardness {
  double shore_a = 0.0;
  double shore_00 = 0.0;
};

// Of a data sheet's 100 % modulus in psi.
constexpr SiliconeGrade row(std::string_view name, Hardness hardness, double modulus_psi, double gravity,
                            double base_per_hardener = 1.0) {
  return {.name = name,
          .shore_a = hardness.shore_a,
          .shore_00 = hardness.shore_00,
          .young_modulus = young_modulus_from_100_percent(modulus_psi * psi),
          .density = gravity * gram_per_cm3,
          .base_per_hardener = base_per_hardener};
}

// Dragon Skin FX-Pro is not here: for its 37.7 psi no source was found. They would make it (Shore 2A) stiffer than
// Dragon Skin 10 (10A, 22 psi), and are four times what tensile tests have (docs/theory/actuator.md, "Silicones").
constexpr std::array table{
    // Smooth-On, technical bulletins "Ecoflex Series" and "Dragon Skin Series", by public texts that quote them.
    row("Ecoflex 00-10", {.shore_00 = 10.0}, 8.0, 1.04),
    row("Ecoflex 00-20", {.shore_00 = 20.0}, 8.0, 1.07),
    row("Ecoflex 00-30", {.shore_00 = 30.0}, 10.0, 1.07),
    row("Ecoflex 00-50", {.shore_00 = 50.0}, 12.0, 1.07),
    row("Dragon Skin 10", {.shore_a = 10.0}, 22.0, 1.07),
    row("Dragon Skin 20", {.shore_a = 20.0}, 49.0, 1.08),
    row("Dragon Skin 30", {.shore_a = 30.0}, 86.0, 1.08),
    // Smooth-On too, but no text with these moduli and densities was found to check them by (Smooth-Sil: the ratio of
    // the
    // parts was).
    row("Mold Star 15", {.shore_a = 15.0}, 55.0, 1.18),
    row("Mold Star 30", {.shore_a = 30.0}, 96.0, 1.12),
    row("Smooth-Sil 940", {.shore_a = 40.0}, 200.0, 1.18, 10.0),
    row("Smooth-Sil 950", {.shore_a = 50.0}, 272.0, 1.24, 10.0),
    // Wacker and Dow state no modulus at 100 %: Gent's of their hardness. Hardness and density: Wacker's data sheet,
    // vulcanised for 24 h at 23 degC, as a public text quotes it; its ratio of parts was not found.
    SiliconeGrade{.name = "Elastosil M 4601",
                  .shore_a = 28.0,
                  .young_modulus = 1.0511e6,
                  .density = 1130.0,
                  .base_per_hardener = 9.0},
    // Hardness and density not found in a text to check them by; 10 to 1 was.
    SiliconeGrade{.name = "Sylgard 184",
                  .shore_a = 43.0,
                  .young_modulus = 1.8910e6,
                  .density = 1030.0,
                  .base_per_hardener = 10.0},
};

}  // namespace

std::span<const SiliconeGrade> silicone_grades() noexcept {
  return table;
}

}  // namespace coilwright::mechanics
