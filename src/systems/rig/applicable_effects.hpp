#pragma once

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::systems::rig {

/// The design without the effects that it cannot have. Precondition: it can be built without any.
[[nodiscard]] actuator::Design without_inapplicable_effects(actuator::Design design);

}  // namespace coilwright::systems::rig
