#pragma once

#include <array>
#include <cstddef>

namespace coilwright::magnetics {

constexpr double square_root(double x) {
  double root = x < 1.0 ? 1.0 : x;
  for (double next = 0.5 * (root + x / root); next < root; next = 0.5 * (root + x / root)) root = next;
  return root;
}

/// Six steps are enough for the least k' there is, the 1e-15 that the kernels give to circles that touch.
using SquaredModuli = std::array<double, 6>;

/// Element i is the least k'^2 for which i steps of the arithmetic-geometric mean are enough, that is, leave means that
/// differ by less than `difference` of themselves. The kernels then err by about a tenth of its half to the fourth
/// power. One step turns k' into 2 sqrt(k') / (1 + k').
constexpr SquaredModuli squared_moduli(double difference) {
  SquaredModuli least{};
  double ratio = 1.0 - difference;
  for (double& square : least) {
    const double root = ratio / (1.0 + square_root((1.0 - ratio) * (1.0 + ratio)));
    ratio = root * root;
    square = ratio * ratio;
  }
  return least;
}

inline constexpr SquaredModuli exact_moduli = squared_moduli(4e-4);  ///< kernels good to 2e-16
inline constexpr SquaredModuli field_moduli = squared_moduli(1e-2);  ///< kernels good to 6e-11

/// Steps needed for circles whose nearest distance squared is k'^2 = `squared_modulus` times their farthest.
constexpr int landen_steps_needed(double squared_modulus, const SquaredModuli& least) {
  int steps = 0;
  while (steps < 6 && squared_modulus < least[static_cast<std::size_t>(steps)]) ++steps;
  return steps;
}

}  // namespace coilwright::magnetics
