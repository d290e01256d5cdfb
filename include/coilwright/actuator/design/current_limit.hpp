#pragma once

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// Chassis-wiring current of the design's wire by its AmpacityChoice, A: a rule of thumb for single wires in free air.
/// The temperatures decide whether a coil may carry it. Throws std::invalid_argument for a gauge outside the table.
[[nodiscard]] double current_limit(const Design& design);

/// The operating current at which the coil with the largest share carries current_limit(), A.
[[nodiscard]] double operating_current_limit(const Design& design);

}  // namespace coilwright::actuator
