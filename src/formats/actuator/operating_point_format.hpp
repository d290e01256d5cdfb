#pragma once

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::formats {

/// A current in every coil, A, as files and the command line take it.
[[nodiscard]] text::Rule current_rule();

/// Every key of an operating point but its current, which a study may vary; what is absent stays as it is in `point`.
void read_operating_conditions(text::ObjectReader& in, actuator::OperatingPoint& point);

/// The operating point of an actuator's own file: its conditions and "current_A", which must be there.
[[nodiscard]] actuator::OperatingPoint read_operating_point(const text::Node& node);

}  // namespace coilwright::formats
