#pragma once

#include <span>

#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Every quantity of a design under its name, null where it has no value, then the joint angles (deg) at rest, steady
/// and in the blocked grasp, and the modes.
[[nodiscard]] text::Json to_json(const simulation::DesignView& design,
                                 const simulation::QuantityTable& quantities = simulation::standard_quantities());

/// The same for a lumped model: only the quantities that need no design. Current in A.
[[nodiscard]] text::Json to_json(const simulation::MotionSummary& motion, double current,
                                 const simulation::QuantityTable& quantities = simulation::standard_quantities());

/// A mode: its natural frequency in Hz, its damping ratio.
[[nodiscard]] text::Json mode_json(const simulation::Mode& mode);

/// The key "part_limits" of `evaluate --json`.
[[nodiscard]] text::Json to_json(std::span<const simulation::PartLimit> limits);

/// The key "assumptions" of `evaluate --json`: every quantity under each other modelling choice.
[[nodiscard]] text::Json to_json(std::span<const simulation::ChoiceEffect> effects);

/// The description of a choice: subject, taken, otherwise, settled_by.
[[nodiscard]] text::Json to_json(const actuator::OtherChoice& choice);

/// The key "torque_correction" of `evaluate --json`: for each variable of a nameless correction the range in which it
/// was measured, the range in which it is used, and whether it is used beyond.
[[nodiscard]] text::Json to_json(std::span<const simulation::CorrectionReach> reach);

}  // namespace coilwright::formats
