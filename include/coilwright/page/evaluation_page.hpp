#pragma once

#include <span>
#include <string_view>

#include "coilwright/page/page.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::page {

/// The page of one design at its operating point: what it does, what its parts stand, what that rests on, drawn and
/// simulated as in the page of a `size`. `effects` are simulation::choice_effects of the design there, `name` is the
/// actuator's, `made_by` program and version.
[[nodiscard]] Page evaluation_page(const simulation::EvaluatedDesign& evaluated,
                                   std::span<const simulation::ChoiceEffect> effects, std::string_view name,
                                   std::string_view made_by);

}  // namespace coilwright::page
