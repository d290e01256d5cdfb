// Magnets as point dipoles.
#pragma once

#include <array>

namespace second_engine {

using Vector = std::array<double, 3>;

double dot(const double* a, const double* b);

// Force and torque of one point dipole on another at `r` from it, and the torque on itself. SI.
struct DipolePull {
  Vector force, torque_on_second, torque_on_first;
};

DipolePull dipole_pull(const Vector& first, const Vector& second, const Vector& r);

}  // namespace second_engine
