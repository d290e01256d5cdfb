#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "truth/finger.hpp"
#include "truth/rig.hpp"
#include "truth/unmodelled_effects.hpp"

namespace truth {

/// A commanded current for both coils, each sample held until the next, and when the camera looks.
struct Experiment {
  std::string name;
  std::vector<double> times;     ///< s, increasing from 0
  std::vector<double> currents;  ///< A, one per sample
  int number = 0;                ///< of the run in the session: random events are drawn for each
  double session_time = 0.0;     ///< s since the start of the session
  std::vector<double> seen{};    ///< s, increasing: when the camera looks; empty: at `times`
  Rig rig{};

  [[nodiscard]] const std::vector<double>& camera_times() const { return seen.empty() ? times : seen; }
};

/// Joint angles at the times that the camera shows (delayed, frozen or jittering with such an effect), rad, one pair
/// per camera time. Scale, offset, parallax and hum of the camera are not in it.
using Trajectory = std::vector<std::array<double, 2>>;

struct State {
  std::array<double, 2> angles{};
  std::array<double, 2> rates{};
};

/// Joint angles in equilibrium under a constant current, rad. Throws std::runtime_error if there is none.
[[nodiscard]] std::array<double, 2> equilibrium(const Finger& finger, const UnmodelledEffects& effects, double current,
                                                const Rig& rig = {});

/// Joint accelerations of a moving finger without effects that have internal states, rad/s^2.
[[nodiscard]] std::array<double, 2> accelerations(const Finger& finger, const UnmodelledEffects& effects,
                                                  const State& state, double current, const Rig& rig = {});

/// The motion from equilibrium under the first current. No noise. Throws std::runtime_error if the finger leaves its
/// range of angles.
[[nodiscard]] Trajectory simulate(const Finger& finger, const UnmodelledEffects& effects, const Experiment& experiment);

/// The range of the joint angles, rad.
struct AngleRange {
  double lowest{};
  double highest{};
};

/// That of a finger without unmodelled effects in all `runs`.
[[nodiscard]] AngleRange angle_range_of(const Finger& finger, const std::vector<Experiment>& runs);

/// Largest rate of the sum of both angles, rad/s, at the ends of integration steps, none longer than a sample.
[[nodiscard]] double peak_bending_rate(const Finger& finger, const UnmodelledEffects& effects,
                                       const Experiment& experiment);

}  // namespace truth
