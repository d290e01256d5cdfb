#pragma once

#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {

/// What coils and magnets reach when the operating point is held with the joints at `angles` (rad, one per joint).
/// Throws std::invalid_argument for a duty outside 0 to 1.
[[nodiscard]] Heat heat_of(const actuator::Design& design, const actuator::Assembly& assembly,
                           const OperatingPoint& point, const mechanics::JointVector& angles);

/// Of every component in that state, base to tip, degC; empty in a thermal runaway. Throws as heat_of().
[[nodiscard]] thermal::NodeVector steady_temperatures(const actuator::Design& design,
                                                      const actuator::Assembly& assembly, const OperatingPoint& point,
                                                      const mechanics::JointVector& angles);

}  // namespace coilwright::simulation
