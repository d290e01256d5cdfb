#pragma once

#include <string>

#include "coilwright/report/json.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::report {

/// Every quantity of a candidate under its name, null where it does not exist, then the joint angles (deg) at rest,
/// steady and in the blocked grasp, and the modes.
[[nodiscard]] Json to_json(const simulation::Candidate& candidate);

/// The same of a model that is given by its lumps alone: what needs no design.
[[nodiscard]] Json to_json(const simulation::Motion& motion, double current);

/// A line a quantity: name, value, meaning; then the joint angles.
[[nodiscard]] std::string to_text(const simulation::Candidate& candidate);

/// The same for a lumped model.
[[nodiscard]] std::string to_text(const simulation::Motion& motion, double current);

}  // namespace coilwright::report
