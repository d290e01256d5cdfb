#pragma once

#include <string>
#include <variant>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/text/json/document.hpp"
#include "formats/actuator/design_reader.hpp"
#include "formats/actuator/lumped_model_reader.hpp"

namespace coilwright::formats {

/// An actuator file in terms of its own numbers.
struct ActuatorContent {
  std::string name;
  std::variant<DesignContent, LumpedModelContent> content;
};

/// Its effects are of `known`.
[[nodiscard]] ActuatorContent read_actuator_content(const text::Document& document,
                                                    const actuator::EffectCatalogue& known);

}  // namespace coilwright::formats
