#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "coilwright/thermal/network.hpp"
#include "coilwright/thermal/transient.hpp"

namespace coilwright::thermal {

/// Returns the heat made in each node, W, at mean temperatures of the nodes (degC); one value per node.
using HeatAt = std::function<NodeVector(const NodeVector&)>;

/// Duration of a course of temperatures, and the times of its samples.
struct CourseTiming {
  double duration{};                                         ///< s; finite, > 0
  double interval{};                                         ///< between looks, s; finite, > 0, at most duration
  double highest = std::numeric_limits<double>::infinity();  ///< the course ends when a node's mean reaches this, degC
};

/// Temperatures over time, from those of the surroundings on.
struct TemperatureCourse {
  std::vector<double> times{};              ///< 0, every interval, and the end, s
  std::vector<NodeVector> temperatures{};   ///< temperatures at these times, degC, one value per node
  std::optional<TimeToLimit> limit{};       ///< first passing of a limit by a coil or magnet, and its node
  std::optional<double> highest_reached{};  ///< time at which a node reached `highest`, s; later times do not exist
};

/// Follows C dT/dt = heat(T) - G (T - ambient) for heat that depends on the temperatures in any way; for constant
/// currents Transient is exact. The method is Dormand and Prince's pair (Boost.Odeint) to 1e-7 of a temperature per
/// step, with limits found on its interpolation. Throws std::invalid_argument naming the field, the rule and the value
/// received.
[[nodiscard]] TemperatureCourse temperature_course(const Network& network, const HeatAt& heat,
                                                   const CourseTiming& timing);

}  // namespace coilwright::thermal
