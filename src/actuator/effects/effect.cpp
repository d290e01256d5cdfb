#include "coilwright/actuator/effect.hpp"

#include <algorithm>

#include "coilwright/actuator/model_spec.hpp"

namespace coilwright::actuator {

void EffectTerm::settle(const Motion& /*motion*/, const CoilCurrents& /*currents*/, double* out) const {
  std::fill_n(out, states(), 0.0);
}

void EffectTerm::drive(Own /*own*/, CoilCurrents& /*currents*/) const {}

void EffectTerm::magnetize(Own /*own*/, const CoilCurrents& /*currents*/, CoilCurrents& /*strength*/) const {}

void EffectTerm::add_torques(const Motion& /*motion*/, const CoilCurrents& /*strength*/, Own /*own*/,
                             mechanics::JointVector& /*torques*/) const {}

void EffectTerm::add_damping(const Motion& /*motion*/, const CoilCurrents& /*strength*/,
                             mechanics::JointMatrix& /*damping*/) const {}

std::optional<std::string> EffectKind::inapplicable(const ModelSpec& spec) const {
  if ((stage() == Stage::drive || stage() == Stage::magnetics) && spec.coils == 0) return "the model has no coils";
  return std::nullopt;
}

}  // namespace coilwright::actuator
