#pragma once

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/systems/rig/per_fidelity.hpp"

// What the rigs have in common.
namespace coilwright::systems::rig {

/// What turning an angle from degrees (rad), or a height from millimetres (relative), may leave beyond a bound.
inline constexpr double rounding = 1e-8;

/// The design without the effects that it cannot have. Precondition: it can be built without any.
[[nodiscard]] actuator::Design without_inapplicable_effects(actuator::Design design);

/// The design assembled once for each fidelity. Precondition: it can be built.
[[nodiscard]] inline PerFidelity<actuator::Model> models_of(const actuator::Design& design) {
  return per_fidelity(
      [&](magnetics::Fidelity fidelity) { return actuator::assemble_or_throw(with_fidelity(design, fidelity)).model; });
}

}  // namespace coilwright::systems::rig
