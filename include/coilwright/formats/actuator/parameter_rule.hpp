#pragma once

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/text/rule.hpp"

namespace coilwright::formats {

/// The rule of a parameter of a Design in the terms of an input file: in the unit of its key. Of a parameter that has
/// names it says nothing.
[[nodiscard]] text::Rule rule_of(const actuator::Parameter& parameter);

/// The rule of an effect's parameter, in the unit of its key. Of one that has choices it says nothing.
[[nodiscard]] text::Rule rule_of(const actuator::EffectParameter& parameter);

}  // namespace coilwright::formats
