#pragma once

#include <span>
#include <string_view>

namespace coilwright::magnetics {

/// One grade of sintered NdFeB as makers sell it, SI, at 20 degC. Sources: docs/theory/magnetics.md, "Grades".
struct MagnetGrade {
  std::string_view name;            ///< "N52", "N42SH"
  double remanence{};               ///< Br, T, typical
  double least_remanence{};         ///< Br that makers guarantee, T
  double coercivity{};              ///< HcJ (intrinsic) that makers guarantee, A/m
  double induction_coercivity{};    ///< HcB that makers guarantee, A/m
  double remanence_coefficient{};   ///< alpha of Br from 20 degC to the temperature limit, 1/K; < 0
  double coercivity_coefficient{};  ///< beta of HcJ over the same range, 1/K; < 0
  double recoil_permeability{};     ///< relative, of the line on which a magnet works; >= 1
  double density{};                 ///< kg/m^3
  double temperature_limit{};       ///< highest working temperature as makers state it, degC; for thick magnets
  double price_ratio{};             ///< per volume, over that of N52
};

/// What a material with that temperature coefficient (of Br or HcJ, 1/K) has at a temperature (degC) over what it has
/// at 20 degC: linear, >= 0.
[[nodiscard]] double share_at(double temperature, double coefficient) noexcept;

/// Every grade, by class (no letter, M, H, SH) and then by remanence. The table lives as long as the program.
[[nodiscard]] std::span<const MagnetGrade> magnet_grades() noexcept;

/// The grade of that name; nullptr if there is none.
[[nodiscard]] const MagnetGrade* find_magnet_grade(std::string_view name) noexcept;

}  // namespace coilwright::magnetics
