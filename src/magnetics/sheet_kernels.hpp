#pragma once

#include <cstddef>
#include <span>

#include "magnetics/gauss_legendre.hpp"

namespace coilwright::magnetics {

/// A set of thin current sheets (or loops) of radii centre + half_width * node.
struct RadialNodes {
  QuadratureRule rule;
  double centre;
  double half_width;
};

/// One face of a source against one face (or loop) of the other body.
struct FacePair {
  RadialNodes nodes;  ///< radii on the first body
  double offset;      ///< axial offset of the two faces, m, signed
  double sign;        ///< +1 or -1
  int landen_steps;   ///< square roots spent on the arithmetic-geometric mean, from landen_steps_needed
};

/// Steps after which the kernels are good to about 1e-14, for loops whose nearest distance squared is `near_squared`
/// and farthest `far_squared` (m^2): the root of their ratio is the complementary modulus k'.
[[nodiscard]] int landen_steps_needed(double near_squared, double far_squared);

/// Sum over pairs of sign * mean over nodes of Phi(radius, other_radius, offset) / mu0, m^2 ... the mutual inductance
/// of two coaxial loops integrated over their offset; the force of two sheets is a second difference of it.
[[nodiscard]] double sum_of_inductance_integrals(std::span<const FacePair> pairs, double other_radius);

/// Sum over pairs of sign * mean over nodes of M(radius, other_radius, offset) / mu0, m: mutual inductance of two
/// coaxial loops.
[[nodiscard]] double sum_of_inductances(std::span<const FacePair> pairs, double other_radius);

/// Where the field is wanted, in the source's cylindrical coordinates; sizes are multiples of 8.
struct FieldPoints {
  std::span<const double> radius;  ///< distance from the axis, m, >= 0
  std::span<const double> height;  ///< along the axis from the centre, m
};

struct FieldValues {
  std::span<double> radial;  ///< H_r, A/m, per A/m of sheet current
  std::span<double> axial;   ///< H_z, A/m
};

/// Field of the mean of the sheets of `nodes`, each reaching `half_length` up and down from the source's centre.
void field_of_sheets(const RadialNodes& nodes, double half_length, int landen_steps, const FieldPoints& points,
                     const FieldValues& values);

}  // namespace coilwright::magnetics
