#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

// Forces from the mutual inductance of circular loops alone (Maxwell's formula), with the standard library's elliptic
// integrals in long double and adaptive quadrature: shares neither formulas nor integrals nor quadrature with the
// library.
namespace coilwright::magnetics::filament_reference {

using Real = long double;

/// Mutual inductance of two coaxial loops over mu0, m: sqrt(a b) ((2/k - k) K - 2/k E).
inline Real inductance(Real a, Real b, Real s) {
  const Real k = std::sqrt(4 * a * b / ((a + b) * (a + b) + s * s));
  return std::sqrt(a * b) * ((2 / k - k) * std::comp_ellint_1(k) - 2 / k * std::comp_ellint_2(k));
}

/// Two coaxial sheets of lengths l1, l2: the double integral of dM/ds, one of them done by hand.
inline Real sheet_force(Real a, Real l1, Real b, Real l2, Real distance) {
  const auto difference = [&](Real v) {
    return inductance(a, b, distance + v + l2 / 2) - inductance(a, b, distance + v - l2 / 2);
  };
  // Break where a face passes a face: the inductance of equal loops is singular there.
  Real from = -l1 / 2;
  Real sum = 0;
  const auto up_to = [&](Real to) {
    if (to > from && to <= l1 / 2) {
      sum += boost::math::quadrature::gauss_kronrod<Real, 31>::integrate(difference, from, to, 8, 1e-12L);
      from = to;
    }
  };
  const Real first = std::min(-distance - l2 / 2, -distance + l2 / 2);
  up_to(first);
  up_to(first + l2);
  up_to(l1 / 2);
  return sum;
}

/// Mean of the sheet force over radii from `inner` to `outer`.
inline Real thick_force(Real inner, Real outer, Real l1, Real b, Real l2, Real distance) {
  const auto at = [&](Real a) { return sheet_force(a, l1, b, l2, distance); };
  using Rule = boost::math::quadrature::gauss_kronrod<Real, 31>;
  if (inner < b && b < outer)
    return (Rule::integrate(at, inner, b, 4, 1e-11L) + Rule::integrate(at, b, outer, 4, 1e-11L)) / (outer - inner);
  return Rule::integrate(at, inner, outer, 4, 1e-11L) / (outer - inner);
}

}  // namespace coilwright::magnetics::filament_reference
