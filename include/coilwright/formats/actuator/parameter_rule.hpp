#pragma once

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/text/rule.hpp"

namespace coilwright::formats {

/// The rule of a parameter of a Design, in the unit of its key. It does not apply to a parameter that is a choice.
[[nodiscard]] text::Rule rule_of(const actuator::Parameter& parameter);

/// The rule of an effect's parameter, in the unit of its key. It does not apply to a parameter that has choices.
[[nodiscard]] text::Rule rule_of(const actuator::EffectParameter& parameter);

}  // namespace coilwright::formats
