#pragma once

#include <optional>
#include <variant>

#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {

/// Whether temperature changes what a design does: its magnets have a grade.
[[nodiscard]] bool feels_heat(const actuator::Design& design);

/// The free finger, held at an operating point until its temperatures are steady. `cold` is its motion at 20 degC. The
/// heat is at the joint angles where the step ends, and the magnets have their polarisation at that heat: both agree.
/// NoPerformance where the warm finger has no motion.
[[nodiscard]] std::variant<FreeCase, NoPerformance> free_case(const actuator::Design& design,
                                                              const actuator::Assembly& assembly,
                                                              const OperatingPoint& point, const MotionSummary& cold);

/// The same with its tip against a wall. Its force without current is that of the cold one: without current it is cold.
[[nodiscard]] std::variant<GrippingCase, NoPerformance> gripping_case(const actuator::Design& design,
                                                                      const actuator::Assembly& assembly,
                                                                      const OperatingPoint& point,
                                                                      const MotionSummary& cold);

}  // namespace coilwright::simulation
