#include "coilwright/mechanics/silicone_hinge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace coilwright::mechanics {
namespace {

void check_positive(double value, const char* field) {
  if (!std::isfinite(value) || value <= 0.0)
    throw std::invalid_argument(fmt::format("{} must be finite and > 0; got {}", field, value));
}

}  // namespace

double young_modulus_from_shore_a(double shore_a) {
  if (!(shore_a >= 20.0 && shore_a <= 80.0))
    throw std::invalid_argument(fmt::format("shore_a must lie in 20 to 80; got {}", shore_a));
  return 1e6 * 0.0981 * (56.0 + 7.62336 * shore_a) / (0.137505 * (254.0 - 2.54 * shore_a));
}

double young_modulus_from_shore_00(double shore_00) {
  if (!(shore_00 >= 10.0 && shore_00 <= 70.0))
    throw std::invalid_argument(fmt::format("shore_00 must lie in 10 to 70; got {}", shore_00));
  constexpr double radius = 1.19e-3;     // of the sphere, m
  constexpr double least_force = 0.203;  // of the spring at 0, N
  constexpr double spring = 9.08e-3;     // N a point
  constexpr double travel = 25.4e-6;     // m a point
  const double force = least_force + spring * shore_00;
  const double depth = travel * (100.0 - shore_00);
  return 9.0 * force / (16.0 * std::sqrt(radius) * depth * std::sqrt(depth));
}

double ligament_stiffness(const Ligament& ligament, const Rubber& rubber) {
  check_positive(ligament.width, "width");
  check_positive(ligament.height, "height");
  if (!std::isfinite(ligament.slot_width) || ligament.slot_width < 0.0)
    throw std::invalid_argument(fmt::format("slot_width must be finite and >= 0; got {}", ligament.slot_width));
  check_positive(rubber.young_modulus, "young_modulus");
  if (!(rubber.poisson_ratio >= 0.0 && rubber.poisson_ratio <= 0.5))
    throw std::invalid_argument(fmt::format("poisson_ratio must lie in 0 to 0.5; got {}", rubber.poisson_ratio));
  // Compliance of the slit, of the beam that a slot adds, and what the two have in common.
  check_positive(rubber.modulus_above, "modulus_above");
  // A homogeneous body has 15.8; the exponent is that of the elements.
  const double slit = 15.8 + 7.03 * (std::pow(rubber.modulus_above, -0.542) - 1.0);
  constexpr double shared = 0.503;
  constexpr double reach = 0.22;
  const double slot = ligament.slot_width / ligament.height;
  const double compliance = slit + 12.0 * slot - shared * (1.0 - std::exp(-slot / reach));
  const double plane_strain_modulus = rubber.young_modulus / (1.0 - rubber.poisson_ratio * rubber.poisson_ratio);
  return plane_strain_modulus * ligament.width * ligament.height * ligament.height / compliance;
}

double hinge_stiffness(const HingeStrip& strip, double young_modulus) {
  check_positive(strip.width, "width");
  check_positive(strip.height, "height");
  check_positive(strip.length, "length");
  check_positive(young_modulus, "young_modulus");
  return young_modulus * strip.width * strip.height * strip.height * strip.height / (12.0 * strip.length);
}

}  // namespace coilwright::mechanics
