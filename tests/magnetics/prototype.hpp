#pragma once

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {

// Coil and magnet of the source paper's Table I and II.
inline const ThickCoil prototype(
    {.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns_radial = 15, .turns_axial = 30});
inline const CylinderMagnet prototype_magnet({.radius = 10e-3, .length = 6e-3, .remanence = 1.44});

}  // namespace coilwright::magnetics
