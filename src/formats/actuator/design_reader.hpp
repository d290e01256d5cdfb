#pragma once

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// The keys of `actuator/1` but format and name; its effects are of `known`.
[[nodiscard]] actuator::Design read_design(text::ObjectReader& in, const actuator::EffectCatalogue& known);

/// One of "A" to "D".
[[nodiscard]] actuator::Configuration read_configuration(const text::Node& node);

/// The rule of a parameter of a Design in the terms of an input file.
[[nodiscard]] text::Rule rule_of(const actuator::Parameter& parameter);

}  // namespace coilwright::formats
