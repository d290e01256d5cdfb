#pragma once

#include <span>

#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::mechanics {

/// Adds the rotors to a mass matrix over the absolute angles: that of joint j has the energy J (phi_j' - phi_j-1')^2
/// / 2.
inline void add_rotors(std::span<const Link> links, JointMatrix& mass) {
  for (int j = 0; j < static_cast<int>(links.size()); ++j) {
    const double rotor = links[static_cast<std::size_t>(j)].rotor_inertia;
    mass(j, j) += rotor;
    if (j == 0) continue;
    mass(j - 1, j - 1) += rotor;
    mass(j, j - 1) -= rotor;
    mass(j - 1, j) -= rotor;
  }
}

}  // namespace coilwright::mechanics
