#pragma once

#include <string_view>

#include "coilwright/control/current_profile.hpp"
#include "coilwright/simulation/modes.hpp"

namespace coilwright::control {

/// The split of a step into pieces whose vibrations cancel.
enum class Shaper {
  step,            ///< not split
  zero_vibration,  ///< two pieces half a period apart, which leave nothing of a mode with exactly these numbers
  zero_vibration_derivative,  ///< three pieces, which leave a rest that grows with the square of an error of the
                              ///< frequency
};

/// The name of a shaper: "step", "zero_vibration", "zero_vibration_derivative".
[[nodiscard]] std::string_view name_of(Shaper shaper);

/// A step of the current from `from` to `to` (A) at time 0, split for a mode into pieces (1, K) / (1 + K), or (1, 2 K,
/// K^2) / (1 + K)^2, half a damped period apart, K = exp(-pi zeta / sqrt(1 - zeta^2)) (Singer and Seering, J. Dyn.
/// Syst. Meas. Control 112, 76, 1990). It is exact for one linear mode; a finger has more modes, and its torque falls
/// with its angle. A mode that does not oscillate (damping ratio 1 and more) leaves the step whole. Throws
/// std::invalid_argument unless the currents are finite, frequency and damping ratio > 0.
[[nodiscard]] CurrentProfile shaped_step(double from, double to, const simulation::Mode& mode, Shaper shaper);

}  // namespace coilwright::control
