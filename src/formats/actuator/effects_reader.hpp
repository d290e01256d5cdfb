#pragma once

#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/actuator/parameter_rule.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// The key "effects" of an actuator file, `[{"id": "dry_friction", "parameters": {"torque_Nmm": 0.61}}]`: effects that
/// the model has beside its stages. Empty where the key is absent. An
/// effect is one of `known`.
[[nodiscard]] std::vector<actuator::Effect> read_effects(text::ObjectReader& in,
                                                         const actuator::EffectCatalogue& known);

}  // namespace coilwright::formats
