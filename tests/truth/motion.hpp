#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "truth/finger.hpp"
#include "truth/quirks.hpp"

namespace truth {

/// What is done to the finger: a current for both coils, each sample held until the next.
struct Experiment {
  std::string name;
  std::vector<double> times;     ///< s, increasing from 0
  std::vector<double> currents;  ///< A, one a sample
  int number = 0;                ///< in the session: chance is drawn anew for each
  double session_time = 0.0;     ///< s since the session began
};

/// Joint angles at the instants that the camera shows (late, frozen, jittering where a quirk says so), rad, a sample
/// each. What the camera makes of an angle is not in it.
using Record = std::vector<std::array<double, 2>>;

struct State {
  std::array<double, 2> angles{};
  std::array<double, 2> rates{};
};

/// Joint angles in equilibrium under a current held for ever, rad. Throws std::runtime_error where none is found.
[[nodiscard]] std::array<double, 2> equilibrium(const Finger& finger, const Quirks& quirks, double current);

/// Joint accelerations of a moving finger with no quirk of memory, rad/s^2.
[[nodiscard]] std::array<double, 2> accelerations(const Finger& finger, const Quirks& quirks, const State& state,
                                                  double current);

/// The motion from equilibrium under the first current. No noise. Throws std::runtime_error where the finger flies off.
[[nodiscard]] Record record(const Finger& finger, const Quirks& quirks, const Experiment& experiment);

/// Between which angles the joints move, rad.
struct Reach {
  double lowest{};
  double highest{};
};

/// Of a finger without quirks in all `runs`.
[[nodiscard]] Reach reach_of(const Finger& finger, const std::vector<Experiment>& runs);

/// Largest rate of the sum of both angles, rad/s, at the ends of the integrator's steps, none longer than a sample.
[[nodiscard]] double peak_bending_rate(const Finger& finger, const Quirks& quirks, const Experiment& experiment);

}  // namespace truth
