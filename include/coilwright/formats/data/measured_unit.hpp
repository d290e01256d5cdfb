#pragma once

#include <string>
#include <string_view>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

/// A quantity as the report calls it: "torque"; "angle" for both kinds of angles, whose errors are taken together.
[[nodiscard]] std::string_view name_of(measurement::data::ChannelKind quantity);

/// The unit of its errors: deg, deg_s, Nmm, N or K.
[[nodiscard]] units::Unit error_unit(measurement::data::ChannelKind quantity);

/// What the report calls a variable on which a residual may depend: {"angle", rad} is written in deg, {"current
/// history", ...} as it is.
[[nodiscard]] units::Unit variable_unit(std::string_view variable);

/// "mae" and deg make "mae_deg"; no unit leaves the name.
[[nodiscard]] std::string with_unit(std::string_view name, const units::Unit& unit);

}  // namespace coilwright::formats
