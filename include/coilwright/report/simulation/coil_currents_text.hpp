#pragma once

#include <string>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::report {

/// The currents of the coils of a design at an operating current, A: "1.4 A in every coil", or "1.4 and 0.7 A in the
/// coils from base to tip" if they have shares of it.
[[nodiscard]] std::string coil_currents_text(const actuator::Design& design, double current);

}  // namespace coilwright::report
