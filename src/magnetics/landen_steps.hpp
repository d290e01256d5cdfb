#pragma once

#include <array>
#include <cstddef>

namespace coilwright::magnetics {

constexpr double square_root(double x) {
  double root = x < 1.0 ? 1.0 : x;
  for (double next = 0.5 * (root + x / root); next < root; next = 0.5 * (root + x / root)) root = next;
  return root;
}

/// squared_moduli[i] is the least k'^2 for which i steps are enough: the means then differ by less than 4e-4, and the
/// neglected fourth power, ((1 - g/a) / 2)^4, is below 2e-15. One step turns k' into 2 sqrt(k') / (1 + k').
inline constexpr std::array<double, 9> squared_moduli = [] {
  std::array<double, 9> least{};
  double ratio = 1.0 - 4e-4;
  for (double& square : least) {
    const double root = ratio / (1.0 + square_root((1.0 - ratio) * (1.0 + ratio)));
    ratio = root * root;
    square = ratio * ratio;
  }
  return least;
}();

/// Steps of the arithmetic-geometric mean after which the kernels are good to about 1e-14, for circles whose nearest
/// distance squared is k'^2 = `squared_modulus` times their farthest.
constexpr int landen_steps_needed(double squared_modulus) {
  int steps = 0;
  while (steps < 9 && squared_modulus < squared_moduli[static_cast<std::size_t>(steps)]) ++steps;
  return steps;
}

}  // namespace coilwright::magnetics
