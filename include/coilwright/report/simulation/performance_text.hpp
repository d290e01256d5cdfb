#pragma once

#include <span>

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::report {

/// Each quantity with its name, value and meaning; then the joint angles and the modes.
[[nodiscard]] Section quantities_section(
    const simulation::DesignView& design,
    const simulation::QuantityTable& quantities = simulation::standard_quantities());

/// The same for a lumped model. Current in A.
[[nodiscard]] Section quantities_section(
    const simulation::MotionSummary& motion, double current,
    const simulation::QuantityTable& quantities = simulation::standard_quantities());

/// What `evaluate` says of a design: its main figures, the limits of its parts, all quantities, and what they rest on
/// (`effects`, simulation::choice_effects of the design; where they are empty, nothing is said of them).
[[nodiscard]] Document document_of(const simulation::DesignView& design,
                                   std::span<const simulation::ChoiceEffect> effects);

/// The same for a lumped model: its quantities. Current in A.
[[nodiscard]] Document document_of(const actuator::Model& model, const simulation::MotionSummary& motion,
                                   double current);

}  // namespace coilwright::report
