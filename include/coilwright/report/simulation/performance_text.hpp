#pragma once

#include <string>

#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::report {

/// One line for each quantity, with its name, value and meaning; then the joint angles and the modes.
[[nodiscard]] std::string to_text(const simulation::DesignView& design,
                                  const simulation::QuantityTable& quantities = simulation::standard_quantities());

/// The same for a lumped model. Current in A.
[[nodiscard]] std::string to_text(const simulation::MotionSummary& motion, double current,
                                  const simulation::QuantityTable& quantities = simulation::standard_quantities());

}  // namespace coilwright::report
