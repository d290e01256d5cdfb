#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/systems/rig/per_fidelity.hpp"

namespace coilwright::systems::rig {

/// The design assembled once for each fidelity. Precondition: it can be built.
[[nodiscard]] inline PerFidelity<actuator::Model> models_of(const actuator::Design& design) {
  return per_fidelity(
      [&](magnetics::Fidelity fidelity) { return actuator::assemble_or_throw(with_fidelity(design, fidelity)).model; });
}

}  // namespace coilwright::systems::rig
