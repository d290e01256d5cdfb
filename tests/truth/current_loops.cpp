#include "truth/current_loops.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>

namespace truth {
namespace {}  // namespace

double loop_potential(double a, double radius, double height) {
  const double far = (a + radius) * (a + radius) + height * height;
  const double m = 4.0 * a * radius / far;  // parameter; Boost takes the modulus
  if (m < 1e-8) return 0.25 * mu0 * a * a * radius / (far * std::sqrt(far));
  const double k = std::sqrt(m);
  return mu0 / (2.0 * std::numbers::pi) * std::sqrt(far) / radius *
         ((1.0 - 0.5 * m) * boost::math::ellint_1(k) - boost::math::ellint_2(k));
}

double mutual_inductance(double a, double b, double s) {
  return 2.0 * std::numbers::pi * b * loop_potential(a, b, s);
}

LoopField loop_field(double a, double radius, double height) {
  const double far = (a + radius) * (a + radius) + height * height;
  const double near = (a - radius) * (a - radius) + height * height;
  const double k = std::sqrt(4.0 * a * radius / far);
  const double first = boost::math::ellint_1(k);
  const double second = boost::math::ellint_2(k);
  const double scale = mu0 / (2.0 * std::numbers::pi * std::sqrt(far));
  const double square = radius * radius + height * height;
  LoopField field;
  field.axial = scale * (first + (a * a - square) / near * second);
  field.radial = radius < 1e-6 * a ? 0.75 * mu0 * a * a * radius * height / std::pow(a * a + height * height, 2.5)
                                   : scale * height / radius * (-first + (a * a + square) / near * second);
  return field;
}

}  // namespace truth
