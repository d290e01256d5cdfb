#pragma once

#include <variant>
#include <vector>

#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {

/// What a design does at an operating point if one modelling choice is made otherwise.
struct ChoiceEffect {
  actuator::OtherChoice choice;
  std::variant<EvaluatedDesign, NoPerformance> result;
};

/// One entry for each of actuator::other_choices(design). Pure.
[[nodiscard]] std::vector<ChoiceEffect> choice_effects(const actuator::Design& design, const OperatingPoint& point);

}  // namespace coilwright::simulation
