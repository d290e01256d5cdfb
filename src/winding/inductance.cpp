#include "coilwright/winding/inductance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>

namespace coilwright::winding {
namespace {

namespace bm = boost::math;

constexpr double vacuum_permeability = 1.25663706212e-6;  // H/m, CODATA 2018
constexpr double slenderest = 1e4;                        // length over outer radius, and its inverse

// long double would cost Pi(n|m) nine times as much, for digits that the quadrature does not have.
using Policy = bm::policies::policy<bm::policies::promote_double<false>>;

void check(const CoilSection& section) {
  const auto reject = [](const char* field, const char* rule, auto value) {
    throw std::invalid_argument(fmt::format("{}: must be {}; got {}", field, rule, value));
  };
  if (!(std::isfinite(section.inner_radius) && section.inner_radius >= 0.0)) {
    reject("inner_radius", "finite and >= 0", section.inner_radius);
  }
  if (!(std::isfinite(section.outer_radius) && section.outer_radius > section.inner_radius)) {
    reject("outer_radius", "finite and above inner_radius", section.outer_radius);
  }
  if (!(section.length > section.outer_radius / slenderest && section.length < section.outer_radius * slenderest)) {
    reject("length", "between 1e-4 and 1e4 outer radii (outside, differences lose the digits)", section.length);
  }
  if (section.turns < 1) reject("turns", ">= 1", section.turns);
}

// Integral over phi from 0 to pi of cos(phi) sqrt(span^2 - 4ab sin^2(theta)), phi = pi - 2 theta: the elliptic part of
// a disc pair's flux. m = 4ab / span^2 is the parameter (k squared), m1 = 1 - m, K = K(m), E = E(m).
double chord_integral(double span, double m, double m1, double K, double E) {
  return 2.0 * span * (2.0 / (3.0 * m) * ((2.0 * m - 1.0) * E + m1 * K) - E);
}

// Mutual inductance of two current sheets of radii a >= b, both of length h and centred on each other, one turn each,
// divided by 2 mu0 / h^2. Neumann's integral  a b int_0^pi cos(phi) / sqrt(rho^2 + z^2) dphi,
// rho^2 = a^2 + b^2 - 2 a b cos(phi), is integrated twice over z from 0 to h; the term in asinh(h / rho) is integrated
// by parts over phi, which leaves complete elliptic integrals (derivation in docs/theory/winding.md).
double sheet_pair(double a, double b, double h) {
  const double sum = a + b;
  const double span = std::hypot(sum, h);
  const double n = std::min(1.0, 4.0 * a * b / (sum * sum));
  const double n1 = (a - b) * (a - b) / (sum * sum);  // 1 - n without its cancellation
  const double m = std::min(1.0, 4.0 * a * b / (span * span));
  const double m1 = (h * h + (a - b) * (a - b)) / (span * span);
  const double k = std::sqrt(m);
  const double K = bm::ellint_1(k, Policy());
  const double E = bm::ellint_2(k, Policy());
  const double E0 = bm::ellint_2(std::sqrt(n), Policy());
  // At equal radii Pi(n|m) and K(n) are infinite, but their products with n1 vanish (as sqrt(n1) and n1 ln n1).
  const bool apart = n1 > 1e-15;
  const double K0 = apart ? bm::ellint_1(std::sqrt(n), Policy()) : 0.0;
  const double characteristic = apart ? n1 / (n * n) * (K - bm::ellint_3(k, n, Policy())) : 0.0;
  const double by_parts = 8.0 / (sum * sum * span) * ((K - E) / (n * m) + characteristic);
  return a * b * (h * h * a * b * by_parts - chord_integral(span, m, m1, K, E) + chord_integral(sum, n, n1, K0, E0));
}

// The same for any distance of doubled integration, 0 included, and either order of the radii.
double doubly_integrated(double a, double b, double z) {
  return z == 0.0 ? 0.0 : sheet_pair(std::max(a, b), std::min(a, b), std::abs(z));
}

}  // namespace

double inductance(const CoilSection& section) {
  check(section);
  using Outer = bm::quadrature::gauss<double, 4>;
  using Inner = bm::quadrature::gauss<double, 6>;
  const double inner_radius = section.inner_radius;
  const double width = section.outer_radius - inner_radius;
  // Twice the triangle b < a. b = a - (a - r) u^2 crowds the points where the radii meet: there the integrand has
  // terms in (a - b)^2 ln(a - b), and for a coil much shorter than wide nearly a ln(a - b).
  const auto inside = [&](double a) {
    const double reach = a - inner_radius;
    return Inner::integrate(
        [&](double u) { return 2.0 * u * reach * sheet_pair(a, a - reach * u * u, section.length); }, 0.0, 1.0);
  };
  const double pairs = 2.0 * Outer::integrate(inside, inner_radius, section.outer_radius);
  const double turns = section.turns;
  return 2.0 * vacuum_permeability * turns * turns * pairs / (width * width * section.length * section.length);
}

double mutual_inductance(const CoilSection& first, const CoilSection& second, double distance) {
  check(first);
  check(second);
  const double touching = 0.5 * (first.length + second.length);
  // Sums of half pitches that fill their room exactly differ by roundings.
  if (!(std::isfinite(distance) && distance >= touching * (1.0 - 1e-12))) {
    throw std::invalid_argument(
        fmt::format("distance: must be finite and at least half of both lengths ({}); got {}", touching, distance));
  }
  using Rule = bm::quadrature::gauss<double, 16>;
  const double shift = 0.5 * (first.length - second.length);
  // The second difference over both lengths of what is integrated twice over z: the flux between two sheets.
  const auto sheets = [&](double a, double b) {
    return doubly_integrated(a, b, distance + touching) + doubly_integrated(a, b, distance - touching) -
           doubly_integrated(a, b, distance + shift) - doubly_integrated(a, b, distance - shift);
  };
  const double sum = Rule::integrate(
      [&](double a) {
        return Rule::integrate([&](double b) { return sheets(a, b); }, second.inner_radius, second.outer_radius);
      },
      first.inner_radius, first.outer_radius);
  const double area = (first.outer_radius - first.inner_radius) * first.length *
                      (second.outer_radius - second.inner_radius) * second.length;
  const double turns = static_cast<double>(first.turns) * second.turns;
  return vacuum_permeability * turns * sum / area;
}

}  // namespace coilwright::winding
