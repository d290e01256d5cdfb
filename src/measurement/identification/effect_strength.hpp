#pragma once

#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::measurement::identification {

/// The strength of an effect is the distance of its numbers from the values that mean that it is absent.

/// Whether an effect of this kind may act in either direction.
[[nodiscard]] bool may_be_negative(const actuator::EffectKind& kind);
/// The effect at `share` of its distance from absent, inside its bounds. Numbers that are one of a few choices, and
/// those that are absent at infinity, do not change.
[[nodiscard]] actuator::Effect scaled_from_absent(actuator::Effect effect, double share);
/// The same, and those that are absent at infinity (a saturation) are divided by the share.
[[nodiscard]] actuator::Effect at_share_of_strength(actuator::Effect effect, double share);
/// Whether one of its numbers has the value that means that the effect is absent. A number that is absent at infinity
/// never has: a limit beyond the motion gains nothing.
[[nodiscard]] bool is_absent(const actuator::Effect& effect);
/// Its numbers that are one of a few choices.
[[nodiscard]] std::vector<double> choices_of(const actuator::Effect& effect);

}  // namespace coilwright::measurement::identification
