#pragma once

#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Every quantity of a design under its name, null where it has no value, then the joint angles (deg) at rest, steady
/// and in the blocked grasp, and the modes.
[[nodiscard]] text::Json to_json(const simulation::DesignView& design,
                                 const simulation::QuantityTable& quantities = simulation::standard_quantities());

/// The same of a model that is given by its lumps alone: only the quantities that need no design. Current in A.
[[nodiscard]] text::Json to_json(const simulation::MotionSummary& motion, double current,
                                 const simulation::QuantityTable& quantities = simulation::standard_quantities());

}  // namespace coilwright::formats
