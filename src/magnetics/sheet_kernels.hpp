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

/// Sum over pairs of sign * mean over nodes of Phi(radius, other_radius, offset) / mu0, m^2 ... the mutual inductance
/// of two coaxial loops integrated over their offset; the force of two sheets is a second difference of it.
[[nodiscard]] double sum_of_inductance_integrals(std::span<const FacePair> pairs, double other_radius);

/// Sum over pairs of sign * mean over nodes of M(radius, other_radius, offset) / mu0, m: mutual inductance of two
/// coaxial loops.
[[nodiscard]] double sum_of_inductances(std::span<const FacePair> pairs, double other_radius);

}  // namespace coilwright::magnetics
