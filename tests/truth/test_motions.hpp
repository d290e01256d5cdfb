#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "truth/motion.hpp"

namespace truth {

// Largest difference of two integrations of the same damped motion, rad: the tolerance is 1e-9 per step, and there are
// a thousand steps.
inline constexpr double same_motion = 1e-6;

inline Experiment constant(double current, double duration) {
  Experiment experiment;
  for (int i = 0; i <= duration * 500; ++i) {
    experiment.times.push_back(i / 500.0);
    experiment.currents.push_back(current);
  }
  return experiment;
}

inline Experiment release(double current, double duration) {
  Experiment experiment = constant(0.0, duration);
  experiment.currents[0] = current;
  return experiment;
}

inline double bending(const std::array<double, 2>& angles) {
  return angles[0] + angles[1];
}

inline double bending(const UnmodelledEffects& effects, double current) {
  return bending(equilibrium({}, effects, current));
}

inline double largest_gap(const Trajectory& a, const Trajectory& b) {
  double gap = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const int j : {0, 1}) gap = std::max(gap, std::abs(a[i][j] - b[i][j]));
  return gap;
}

inline Experiment ramp(double from, double to, double duration) {
  Experiment experiment;
  const int samples = static_cast<int>(duration * 500);
  for (int i = 0; i <= samples; ++i) {
    experiment.times.push_back(i / 500.0);
    experiment.currents.push_back(from + (to - from) * i / samples);
  }
  return experiment;
}

// The bending angle under a constant torque against the motion: as if the hinges were relaxed at an angle smaller by
// the torque over the stiffness.
inline double bending_against(double torque, double current) {
  return bending({.rest_angle = -torque / Finger{}.stiffness}, current);
}

}  // namespace truth
