#pragma once

#include <vector>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::actuator::effects {

/// How many degrees a radian has: 5.0 / degrees is an angle of 5 degrees.
inline constexpr double degrees = units::degrees_per_radian;

/// `count` >= 2 values from `low` to `high`, equally far apart in logarithm; 0 < low. Where high <= low: low alone.
[[nodiscard]] std::vector<double> log_spread(double low, double high, int count);

/// Every value by itself, as starts of an effect with one parameter.
[[nodiscard]] std::vector<std::vector<double>> one_by_one(const std::vector<double>& values);

/// Every first value with every second one.
[[nodiscard]] std::vector<std::vector<double>> each_with_each(const std::vector<double>& first,
                                                              const std::vector<double>& second);

}  // namespace coilwright::actuator::effects
