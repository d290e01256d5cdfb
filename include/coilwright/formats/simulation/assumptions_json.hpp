#pragma once

#include <span>

#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The key "part_limits" of `evaluate --json`.
[[nodiscard]] text::Json to_json(std::span<const simulation::PartLimit> limits);

/// The key "assumptions" of `evaluate --json`: every quantity under each other modelling choice.
[[nodiscard]] text::Json to_json(std::span<const simulation::ChoiceEffect> effects);

/// What is said of a choice itself: subject, taken, otherwise, settled_by.
[[nodiscard]] text::Json to_json(const actuator::OtherChoice& choice);

}  // namespace coilwright::formats
