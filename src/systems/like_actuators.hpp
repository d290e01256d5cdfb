#pragma once

#include "coilwright/drive/coil_bank.hpp"

namespace coilwright::systems {

/// The coils of `count` >= 1 like actuators on one driver, those of one actuator after those of the other. Between
/// actuators there is no mutual inductance.
[[nodiscard]] drive::CoilBank of_like_actuators(const drive::CoilBank& one, int count);

}  // namespace coilwright::systems
