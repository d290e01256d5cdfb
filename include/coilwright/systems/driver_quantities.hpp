#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "coilwright/drive/driver.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::systems {

/// The pulsed supply of a study: an H-bridge that shorts the coils while off, or a cell with a switch and a diode.
/// Values that are not here are those of drive::HBridge and drive::CellSwitch.
struct DriverTask {
  /// The kind of switching.
  enum class Kind { h_bridge, cell };
  /// Their words.
  static constexpr std::array<std::string_view, 2> kind_words{"h_bridge", "cell"};
  Kind kind{};
  double voltage{};          ///< of the open circuit, V; finite, > 0
  double resistance{};       ///< inside, with leads, ohm; finite, >= 0
  double frequency = 490.0;  ///< of the pulses, Hz; finite, > 0
  /// Largest current of bridge or cell, of all coils, A; finite, > 0.
  double most_current = drive::BridgeRatings{}.peak_current;
  /// Resistance of all switches that the current passes while on, ohm; finite, >= 0.
  double switch_resistance = drive::HBridge{}.high_resistance + drive::HBridge{}.low_resistance;
};

/// The quantities of a driver that gives the operating point's current as the mean current of the coil that carries
/// most: its duty with the coils as warm as in the free finger (in the gripping one if only that is held), its ripple
/// and peaks with coils at 20 degC, where they are largest. If it cannot give that current, none has a value. For
/// studies: objectives, limits, expressions and columns. `task` gives the driver of one design, whose settings may
/// vary; it must be pure. All coils hang on the driver by the operating point's wiring.
[[nodiscard]] std::vector<simulation::ResultQuantity> driver_quantities(
    const std::function<DriverTask(const simulation::Settings&)>& task);

}  // namespace coilwright::systems
