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

double hinge_stiffness(const HingeStrip& strip, double young_modulus) {
  check_positive(strip.width, "width");
  check_positive(strip.height, "height");
  check_positive(strip.length, "length");
  check_positive(young_modulus, "young_modulus");
  return young_modulus * strip.width * strip.height * strip.height * strip.height / (12.0 * strip.length);
}

}  // namespace coilwright::mechanics
