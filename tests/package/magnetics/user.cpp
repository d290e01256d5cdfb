// Two magnets far apart through the installed headers: 0 if they attract each other as dipoles do.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "coilwright/magnetics/axial_force.hpp"

int main() {
  using namespace coilwright::magnetics;
  constexpr double remanence = 1.3, radius = 4e-3, length = 6e-3, distance = 0.2;
  const CylinderMagnet magnet({.radius = radius, .length = length, .remanence = remanence});
  const double force = axial_force(magnet, magnet, distance);
  // -3 mu_0 m^2 / (2 pi d^4) with m = B V / mu_0; the next term is of the order of (length / distance)^2, 0.1 %.
  constexpr double mu_0 = 4e-7 * std::numbers::pi;
  const double moment = remanence * std::numbers::pi * radius * radius * length / mu_0;
  const double dipoles = -3.0 * mu_0 * moment * moment / (2.0 * std::numbers::pi * std::pow(distance, 4));
  std::printf("attraction %.4g N, of dipoles %.4g N\n", -force, -dipoles);
  return std::abs(force / dipoles - 1.0) < 0.01 ? 0 : 1;
}
