#pragma once

#include <span>
#include <string>

#include "coilwright/actuator/design.hpp"
#include "coilwright/formats/declared_actuator.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::report {

/// The key "effects" of an actuator file: read back, they are the same effects.
[[nodiscard]] text::Json to_json(std::span<const actuator::Effect> effects);

/// A design as an `actuator/1` file, with every value, its calibration factors and its effects: read back, it is the
/// same design.
[[nodiscard]] text::Json to_json(const actuator::Design& design, const std::string& name);

/// An actuator after a diagnosis, complete: a design under `name`; a lumped model as its file was, with the new numbers
/// and all effects.
[[nodiscard]] text::Json to_json(const formats::UpdatedActuator& actuator, const std::string& name);

}  // namespace coilwright::report
