#pragma once

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// A current in every coil, A, as files and the command line take it.
[[nodiscard]] text::Rule current_rule();

/// Every key of an operating point but its current, which a study may vary; what is absent stays as it is in `point`.
void read_operating_conditions(text::ObjectReader& in, actuator::OperatingPoint& point);

}  // namespace coilwright::formats
