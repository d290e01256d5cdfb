#pragma once

#include "calibrate_names.hpp"
#include "coilwright/formats/declared_actuator.hpp"
#include "lumped_model_reader.hpp"

namespace coilwright::formats {

/// All of a DeclaredActuator but its name, for each format. Throw InputError.
[[nodiscard]] DeclaredActuator declare(Document document, actuator::Design design, CalibrateNames names);
[[nodiscard]] DeclaredActuator declare(Document document, LumpedModel lumped, CalibrateNames names);

}  // namespace coilwright::formats
