#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "actuator/effects/starts.hpp"

namespace coilwright::actuator::effects {

/// Bounds of a thermal time constant, s: of a bare wire, and of a rig that a day does not warm.
inline constexpr double shortest_heat = 0.1;
inline constexpr double longest_heat = 1e5;

/// Heat that moves within this time constant, s, or less is part of a step's answer; slower heat is held during one.
inline constexpr double slow_time = 1.0;

/// How a run that starts at rest under a current finds the part: cold, as after a pause, or warm, as after a hold that
/// outlasts the heat. Which it was is a matter of the rig's operator; a record tells.
inline constexpr std::array warm_starts = {0.0, 1.0};
inline constexpr EffectParameter warm_start = {
    .key = "warm_start",
    .text = "0: a run that starts at rest starts cold, 1: warm from a long hold under its first current",
    .lower = 0.0,
    .upper = 1.0,
    .choices = warm_starts};

/// Starts of a loss per square ampere with a thermal time constant: a fifth lost at the rig's current, in a twentieth
/// to thrice the longest run, cold and warm.
[[nodiscard]] inline std::vector<std::vector<double>> heat_starts(const RigScale& scale) {
  const double loss = 0.2 / (scale.current * scale.current);
  const double low = std::clamp(0.05 * scale.duration, shortest_heat, longest_heat);
  const double high = std::clamp(3.0 * scale.duration, low, longest_heat);
  std::vector<std::vector<double>> out;
  for (const double time_constant : log_spread(low, high, 3))
    for (const double warm : warm_starts) out.push_back({loss, time_constant, warm});
  return out;
}

}  // namespace coilwright::actuator::effects
