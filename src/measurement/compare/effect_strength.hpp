#pragma once

#include <vector>

#include "coilwright/actuator/effect.hpp"

namespace coilwright::measurement::compare {

/// How strong an effect is: how far its numbers are from the values that mean it is not there.

/// Whether an effect of this kind may act either way.
[[nodiscard]] bool may_be_negative(const actuator::EffectKind& kind);
/// Takes an effect to `share` of its distance from absent, inside its bounds. What is one of a few choices, and what is
/// absent at infinity, stays.
void weaken(actuator::Effect& effect, double share);
/// Whether one of its numbers has the value that means that the effect is not there. A limit that is absent at infinity
/// never is: one beyond the motion gains nothing.
[[nodiscard]] bool is_absent(const actuator::Effect& effect);
/// Its numbers that are one of a few choices.
[[nodiscard]] std::vector<double> choices_of(const actuator::Effect& effect);

}  // namespace coilwright::measurement::compare
