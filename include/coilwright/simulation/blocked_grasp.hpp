#pragma once

#include <optional>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::simulation {

/// The finger hangs straight, its tip against a vertical wall without friction, and cannot bend.
struct BlockedGrasp {
  double force{};                 ///< of the tip on the wall, N, >= 0; 0 where the finger would rather leave the wall
  mechanics::JointVector angles;  ///< of the joints while it presses, rad
};

/// Static equilibrium with the tip held at its straight position across the finger; nothing if there is none near the
/// straight pose. Joints may turn as far as the constraint and their contacts let them.
[[nodiscard]] std::optional<BlockedGrasp> blocked_grasp(const actuator::Model& model,
                                                        const actuator::CoilCurrents& currents);

}  // namespace coilwright::simulation
