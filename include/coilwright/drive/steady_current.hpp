#pragma once

#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/drive/pulses.hpp"

namespace coilwright::drive {

/// Mean powers over the periods evaluated, W. source = coils + switches + diodes + supply + stored.
struct DrivePowers {
  double source{};    ///< supplied by the electromotive force, less what returns to it
  double coils{};     ///< heat in the coils' copper
  double switches{};  ///< heat in the switches
  double diodes{};    ///< heat in the diodes
  double supply{};    ///< heat inside the supply
  double stored{};    ///< growth of the field energy; 0 where the current repeats
};

/// The periodic current under pulses, A, of the driver; a coil has its share.
struct SteadyCurrent {
  double mean{};
  double rms{};
  double peak{};         ///< largest
  double valley{};       ///< smallest
  double supply_mean{};  ///< current that the supply delivers, less what returns to it
  double conduction{};   ///< fraction of the time with a current, 0 to 1
  bool is_limited{};     ///< whether the current limit acted
  /// Whether every period equals the one before. Pulses that beat with a limit's fixed off-time may not repeat; then
  /// the figures are means over 1000 periods after the start has died away, and peak and valley are those of all of
  /// them.
  bool repeats = true;
  DrivePowers powers{};

  [[nodiscard]] double ripple() const noexcept { return peak - valley; }             ///< peak to peak
  [[nodiscard]] bool is_discontinuous() const noexcept { return conduction < 1.0; }  ///< zero for part of a period
};

/// Computes the periodic steady state of L di/dt = source - diodes - (R + resistances) i, phase after phase (on, dead,
/// off, dead), each an exponential in closed form; a current that reaches zero stays there until the next pulse.
/// Without a current limit the start of a period is the fixed point of a linear map, or zero; with one, periods are
/// followed until they repeat. A pulse shorter than the dead time never switches on. Source: circuit theory; Erickson
/// and Maksimovic, Fundamentals of Power Electronics, 2001, ch. 5 (discontinuous conduction). Throws
/// std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] SteadyCurrent steady_current(const Circuit& circuit, const Driver& driver, const Pulses& pulses);

}  // namespace coilwright::drive
