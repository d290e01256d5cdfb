#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace coilwright::drive {

/// The parts of a driver through which the current flows in one phase, beside the coils. The driver itself never
/// reverses a current; motion may (systems::drive_motion), if no diode is in its way.
struct Path {
  double source{};             ///< voltage that drives the current, V; negative if it flows back into the supply
  double diodes{};             ///< forward drops, independent of the current, V; >= 0
  double resistance{};         ///< of the switches, ohm; >= 0
  double supply_resistance{};  ///< inside the supply with its leads, ohm; >= 0
  bool one_way{};              ///< whether diodes carry it, so that it cannot reverse
};

/// Fixed off-time regulation: at the current `trip` the driver shorts the coils for `off_time` and then drives again.
struct CurrentLimit {
  double trip{};      ///< A, of the driver's current; finite, > 0
  double off_time{};  ///< s; finite, > 0
  double blanking{};  ///< time after switching on in which the limit does not act, s; >= 0. The current may pass it
};

/// A driver as its phases: on, off, and between them a dead time in which diodes carry the current.
struct Driver {
  Path on{};
  Path dead{};
  Path off{};
  Path chop{};         ///< path while the current limit holds the coils off
  double dead_time{};  ///< after each of the two edges, s; >= 0. It delays switching on, and does not lengthen it
  std::optional<CurrentLimit> limit{};
};

/// The path of the current in an H-bridge while it is off.
enum class Decay {
  slow,  ///< both low switches on: the coils are shorted, the current dies by resistance
  fast   ///< all switches off: diodes return the current to the supply until it is zero, and then nothing flows
};

/// Their words.
inline constexpr std::array<std::string_view, 2> decay_words{"slow", "fast"};

/// The ranges within which a bridge works. The defaults are those of the DRV8870 and DRV8871 (data sheets, sections 6.1
/// and 6.3).
struct BridgeRatings {
  double lowest_voltage = 6.5;    ///< of the supply, V; finite, >= 0: below it the driver locks its switches
  double highest_voltage = 45.0;  ///< of the supply, V; finite, > 0
  double peak_current = 3.6;      ///< A; finite, > 0: above it the driver switches itself off
};

/// A full bridge of four switches on a supply. The defaults are typical values of an integrated driver of 45 V and 3.6
/// A at 24 V, 1 A and 25 degC (Texas Instruments, data sheet of the DRV8870, section 6.5; the DRV8871 is the same
/// driver with its limit set by a resistor).
struct HBridge {
  double supply_voltage = 24.0;    ///< V; finite, > 0
  double supply_resistance{};      ///< ohm; finite, >= 0; 0 with a large capacitor at the bridge
  double high_resistance = 0.307;  ///< of a high switch, ohm; finite, >= 0
  double low_resistance = 0.258;   ///< of a low switch, ohm; finite, >= 0
  double diode_voltage = 0.8;      ///< of a switch's diode, V; finite, >= 0
  double dead_time = 220e-9;       ///< s; finite, >= 0
  Decay decay = Decay::slow;       ///< while the pulse is off
  std::optional<double> trip{};    ///< of the current limit, A; absent: no limit
  double limit_off_time = 25e-6;   ///< s
  double limit_blanking = 2e-6;    ///< s
  BridgeRatings ratings{};         ///< not checked by driver_of(); systems::drive_actuator warns
};

/// Makes the driver of a bridge. Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] Driver driver_of(const HBridge& bridge);

/// A battery cell with one switch and a diode across the coils.
struct CellSwitch {
  double emf{};                     ///< of the open circuit, V; finite, > 0; taken as constant over the discharge
  double resistance{};              ///< inside the cell with its leads, ohm; finite, >= 0
  double switch_resistance = 0.05;  ///< ohm; finite, >= 0
  double diode_voltage = 0.4;       ///< of the diode, V; finite, >= 0; a Schottky diode's at about 1 A
};

/// Makes the driver of a cell. Throws std::invalid_argument naming the field, the rule and the value received.
[[nodiscard]] Driver driver_of(const CellSwitch& cell);

/// Time for which a cell of `capacity` (A s) delivers `mean_current` (A), s; infinite for no current. The fall of its
/// voltage is not considered. Throws std::invalid_argument unless both are finite, `capacity` is > 0 and `mean_current`
/// >= 0.
[[nodiscard]] double run_time(double capacity, double mean_current);

}  // namespace coilwright::drive
