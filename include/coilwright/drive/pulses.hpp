#pragma once

#include "coilwright/drive/driver.hpp"

namespace coilwright::drive {

/// A train of pulses.
struct Pulses {
  double frequency{};  ///< Hz; finite, > 0
  double duty{};       ///< fraction of a period with the command on, 0 to 1; at 0 and 1 nothing switches
};

/// Length of each phase of a period, in their order, s.
struct PhaseLengths {
  double on{};
  double dead_before_off{};
  double off{};
  double dead_before_on{};
};

/// Computes the lengths. The dead time delays switching on, so it is taken off the pulse: a shorter pulse never
/// switches on, and a shorter pause has no off phase. Precondition: the pulses keep their rules.
[[nodiscard]] PhaseLengths phase_lengths(const Driver& driver, const Pulses& pulses);

}  // namespace coilwright::drive
