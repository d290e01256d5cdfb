#pragma once

#include "coilwright/actuator/parts/magnetic_stage.hpp"

namespace coilwright::actuator {

/// The pairs of one coil and one magnet alone: those whose torque is in proportion to a current. Magnets that pull at
/// each other induce nothing, and what coils induce in each other by moving is left out as being small (1 % of a
/// magnet's).
[[nodiscard]] MagneticStage coil_magnet_pairs(const MagneticStage& magnetics);

}  // namespace coilwright::actuator
