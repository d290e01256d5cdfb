#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/thermal/network.hpp"

namespace coilwright::simulation {

/// Temperatures of a finger's parts over time, from ambient, under the mean load of its operating point.
struct Heating {
  std::vector<double> times{};               ///< s, from 0, even in the logarithm after the first
  std::vector<thermal::NodeVector> means{};  ///< mean temperature of every component, base to tip, degC; a row a time
  std::vector<thermal::NodeVector> hot_spots{};  ///< of the hottest place of every component, degC; likewise
  bool runaway{};  ///< whether there is no steady state; the times then end where a part is hot
};

/// The heating of the free finger at the joint angles where it settles (in a runaway those of its cold step), with the
/// current of the operating point in every coil for the fraction `duty` of the time, in the network of
/// Performance::free's heat. The times run from a hundredth of the shortest time constant of a part to five of the
/// longest; in a runaway until a part is 100 K above its limit. `samples` is 2 or more, otherwise std::invalid_argument
/// is thrown.
[[nodiscard]] Heating heating(const EvaluatedDesign& evaluated, std::size_t samples);

}  // namespace coilwright::simulation
