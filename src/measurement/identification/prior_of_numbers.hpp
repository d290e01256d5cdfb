#pragma once

#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::measurement::identification {

/// The natural logarithm of the prior density of an effect's numbers at `values`, and what a Laplace approximation
/// needs of it. Every number has a coordinate u in which its prior is simple; `slopes` are dphi/du, `precisions` those
/// of the prior of u. Choices are not among them.
///
/// A magnitude (its distance from the value at which the effect is absent) is log-normal about the geometric mean of
/// the catalogue's starts for this rig, with a standard deviation of a factor of 10; where either sign is physical,
/// half of that on each side. A shape that cannot be negative (a time constant, a frequency) is log-normal like a
/// magnitude, an angle of either sign uniform between its bounds, a coefficient with a deviation of its own normal.
/// What lies beyond a number's bounds has no density.
struct PriorOfNumbers {
  double log_density{};  ///< of u, and of the choices that were made
  std::vector<double> slopes{};
  std::vector<double> precisions{};
};
[[nodiscard]] PriorOfNumbers prior_of_numbers(const actuator::Effect& effect, const actuator::RigScale& scale);

}  // namespace coilwright::measurement::identification
