#pragma once

#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {

/// Voltages, currents and power of the coils at their temperatures (degC, one a coil, base to tip). Coils in parallel
/// each get the voltage of the hottest one.
[[nodiscard]] Electrics electrics_at(const actuator::Assembly& assembly, const OperatingPoint& point,
                                     const thermal::NodeVector& coil_temperatures);

}  // namespace coilwright::simulation
