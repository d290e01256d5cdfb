#pragma once

#include "coilwright/actuator/parts/magnetic_stage.hpp"

namespace coilwright::actuator {

/// The pairs of one coil and one magnet, whose torque is proportional to a current. Pairs of magnets induce nothing;
/// the voltages that coils induce in each other by moving are left out (1 % of a magnet's).
[[nodiscard]] MagneticStage coil_magnet_pairs(const MagneticStage& magnetics);

}  // namespace coilwright::actuator
