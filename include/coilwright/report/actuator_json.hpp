#pragma once

#include <string>

#include "coilwright/actuator/design.hpp"
#include "coilwright/report/json.hpp"

namespace coilwright::report {

/// A design as an `actuator/1` file, with every value and its calibration factors: read back, it is the same design.
[[nodiscard]] Json to_json(const actuator::Design& design, const std::string& name);

}  // namespace coilwright::report
