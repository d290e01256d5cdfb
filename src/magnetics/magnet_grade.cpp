#include "coilwright/magnetics/magnet_grade.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace coilwright::magnetics {
namespace {

constexpr double reference = 20.0;     // degC
constexpr double recoil = 1.05;        // makers' tables give this for every grade
constexpr double density = 7500.0;     // kg/m^3; likewise
constexpr double alpha = -0.12e-2;     // 1/K, Arnold; for every class here
constexpr double kiloampere = 1000.0;  // A/m

// What the grades of one letter have in common.
struct Class {
  double beta;   // 1/K
  double limit;  // degC
  int letters;   // steps of coercivity above a grade without a letter
};
constexpr Class n_class{-0.750e-2, 80.0, 0};   // Arnold
constexpr Class m_class{-0.675e-2, 100.0, 1};  // Arnold
constexpr Class h_class{-0.605e-2, 120.0, 2};  // Arnold
constexpr Class sh_class{-0.55e-2, 150.0, 3};  // makers: -0.45 to -0.60

constexpr double power(double base, int exponent) {
  double out = 1.0;
  for (; exponent > 0; --exponent) out *= base;
  for (; exponent < 0; ++exponent) out /= base;
  return out;
}

// A maker's rule of thumb: 5 to 10 % a step of energy product, 10 to 15 % a step of coercivity. `below` counts the
// steps of the usual ladder 35, 38, 40, 42, 45, 48, 50, 52 from N52 down.
constexpr double price_ratio(int below, int letters) {
  return power(1.075, -below) * power(1.125, letters);
}

// Remanences in T, coercivities in kA/m.
constexpr MagnetGrade row(std::string_view name, double remanence, double least, double hcb, double hcj, int below,
                          const Class& letter) {
  return {.name = name,
          .remanence = remanence,
          .least_remanence = least,
          .coercivity = hcj * kiloampere,
          .induction_coercivity = hcb * kiloampere,
          .remanence_coefficient = alpha,
          .coercivity_coefficient = letter.beta,
          .recoil_permeability = recoil,
          .density = density,
          .temperature_limit = letter.limit,
          .price_ratio = price_ratio(below, letter.letters)};
}

// Arnold gives N52 60 degC where most makers give 80 (some 70): it has less coercivity than its neighbours.
constexpr MagnetGrade cooler(MagnetGrade grade, double limit) {
  grade.temperature_limit = limit;
  return grade;
}

constexpr std::array table{
    // Arnold (typical Br, least HcB and HcJ); least Br: First4Magnets.
    row("N35", 1.210, 1.17, 860, 955, 7, n_class),
    row("N38", 1.260, 1.22, 860, 955, 6, n_class),
    row("N40", 1.285, 1.25, 923, 955, 5, n_class),
    row("N42", 1.315, 1.28, 860, 955, 4, n_class),
    row("N45", 1.350, 1.32, 860, 955, 3, n_class),
    row("N48", 1.400, 1.38, 836, 955, 2, n_class),
    row("N50", 1.425, 1.40, 836, 955, 1, n_class),
    cooler(row("N52", 1.450, 1.43, 836, 876, 0, n_class), 60.0),
    // Arnold; least Br: China Magnet Factory, K&J (N52M).
    row("N35M", 1.210, 1.17, 868, 1114, 7, m_class),
    row("N38M", 1.260, 1.22, 899, 1114, 6, m_class),
    row("N40M", 1.285, 1.25, 923, 1114, 5, m_class),
    row("N42M", 1.315, 1.28, 955, 1114, 4, m_class),
    row("N45M", 1.350, 1.32, 971, 1114, 3, m_class),
    row("N48M", 1.395, 1.36, 995, 1114, 2, m_class),
    row("N50M", 1.415, 1.40, 1035, 1114, 1, m_class),
    row("N52M", 1.445, 1.43, 995, 1035, 0, m_class),
    // Arnold; from N40H on China Magnet Factory, typical Br the middle of its range.
    row("N35H", 1.210, 1.17, 868, 1353, 7, h_class),
    row("N38H", 1.260, 1.22, 899, 1353, 6, h_class),
    row("N40H", 1.265, 1.25, 923, 1353, 5, h_class),
    row("N42H", 1.300, 1.28, 955, 1353, 4, h_class),
    row("N45H", 1.330, 1.30, 963, 1353, 3, h_class),
    // K&J Magnetics, typical Br the middle of its range.
    row("N35SH", 1.190, 1.17, 859, 1592, 7, sh_class),
    row("N38SH", 1.240, 1.22, 907, 1592, 6, sh_class),
    row("N40SH", 1.275, 1.26, 907, 1592, 5, sh_class),
    row("N42SH", 1.315, 1.30, 907, 1592, 4, sh_class),
    row("N45SH", 1.350, 1.33, 907, 1512, 3, sh_class),
    row("N48SH", 1.400, 1.38, 907, 1512, 2, sh_class),
};

}  // namespace

double share_at(double temperature, double coefficient) noexcept {
  return std::max(0.0, 1.0 + coefficient * (temperature - reference));
}

std::span<const MagnetGrade> magnet_grades() noexcept {
  return table;
}

const MagnetGrade* find_magnet_grade(std::string_view name) noexcept {
  const auto found = std::ranges::find(table, name, &MagnetGrade::name);
  return found == table.end() ? nullptr : &*found;
}

}  // namespace coilwright::magnetics
