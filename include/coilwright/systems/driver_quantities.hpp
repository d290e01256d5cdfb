#pragma once

#include <functional>
#include <vector>

#include "coilwright/drive/driver.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::systems {

/// The pulsed supply of a study: an H-bridge that shorts the coils while off, or a cell with a switch and a diode. What
/// is not said here is as in drive::HBridge and drive::CellSwitch.
struct DriverTask {
  /// What switches.
  enum class Kind { h_bridge, cell };
  Kind kind{};
  double voltage{};           ///< of the open circuit, V; finite, > 0
  double resistance{};        ///< inside, with leads, ohm; finite, >= 0
  double frequency = 490.0;   ///< of the pulses, Hz; finite, > 0
  double most_current = 3.6;  ///< that bridge or cell bears, of all coils, A; finite, > 0
  /// Of all switches that the current passes while on, ohm; finite, >= 0.
  double switch_resistance = drive::HBridge{}.high_resistance + drive::HBridge{}.low_resistance;
};

/// What such a driver has to do so that the mean current of the coil that carries most is the operating point's: its
/// duty with the coils as warm as the free finger makes them (the gripping one where that alone is held), its ripple
/// and peaks with coils at 20 degC, where they are largest. Where it cannot give that current none has a value. For
/// studies: objectives, limits, expressions and columns. `task` gives that of one design, whose settings may vary; it
/// must be pure. All coils hang on the driver as the operating point's wiring says.
[[nodiscard]] std::vector<simulation::ResultQuantity> driver_quantities(
    const std::function<DriverTask(const simulation::Settings&)>& task);

}  // namespace coilwright::systems
