#include "coilwright/systems/rig/per_fidelity.hpp"

#include <utility>

#include "coilwright/actuator/assemble.hpp"
#include "systems/rig/models_of.hpp"

namespace coilwright::systems::rig {

actuator::Design without_inapplicable_effects(actuator::Design design) {
  if (design.effects.empty()) return design;
  actuator::Design bare = design;
  bare.effects.clear();
  const actuator::ModelSpec spec = actuator::assemble_or_throw(bare).model.nominal_spec();
  std::erase_if(design.effects,
                [&](const actuator::Effect& effect) { return effect.kind->inapplicable(spec).has_value(); });
  return design;
}

actuator::Design with_fidelity(actuator::Design design, magnetics::Fidelity fidelity) {
  if (design.choices.torque == fidelity) return design;
  design.choices.torque = fidelity;
  return without_inapplicable_effects(std::move(design));
}

}  // namespace coilwright::systems::rig
