#pragma once

#include "coilwright/formats/data/declared_actuator.hpp"
#include "formats/actuator/lumped_model_reader.hpp"
#include "formats/data/calibrate_names.hpp"

namespace coilwright::formats {

/// All of a DeclaredActuator but its name, for each format; what is read again has effects of `known`. Throw
/// InputError.
[[nodiscard]] DeclaredActuator declare(text::Document document, actuator::Design design, CalibrateNames names,
                                       const actuator::EffectCatalogue& known);
[[nodiscard]] DeclaredActuator declare(text::Document document, LumpedModel lumped, CalibrateNames names,
                                       const actuator::EffectCatalogue& known);

}  // namespace coilwright::formats
