#pragma once

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The key "operating_point" of an actuator file and of result.json, with every value: read back, it is the same point.
[[nodiscard]] text::Json to_json(const actuator::OperatingPoint& point);

}  // namespace coilwright::formats
