#pragma once

#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::replay {

/// A number of the joints that a fit may move: one value for all joints. Where the joints differ it is their mean, and
/// each joint keeps its ratio to it.
enum class JointNumber { stiffness, damping };

/// A model made in code, to be diagnosed without a file. `calibrated` are the numbers that may be fitted anew before a
/// residual counts; one that is 0 at every joint stays 0. A program that wants to calibrate other numbers fills in a
/// DeclaredModel itself. Throws std::invalid_argument for a number that is given twice.
[[nodiscard]] DeclaredModel declare(actuator::ModelSpec spec, const std::vector<JointNumber>& calibrated = {
                                                                  JointNumber::stiffness, JointNumber::damping});

/// The same for a design, with its heat paths, so that runs may record a temperature. Throws std::invalid_argument with
/// the first rule that the design breaks.
[[nodiscard]] DeclaredModel declare(const actuator::Design& design, const std::vector<JointNumber>& calibrated = {
                                                                        JointNumber::stiffness, JointNumber::damping});

}  // namespace coilwright::measurement::replay
