#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {

/// The figures for which an actuator is usually built: those that are held against every other modelling choice.
inline constexpr std::array<std::string_view, 4> main_figures = {"peak_bending_speed_deg_s", "steady_angle_deg",
                                                                 "grasp_force_N", "damping_ratio"};

/// What a design does at an operating point if one modelling choice is made otherwise.
struct ChoiceEffect {
  actuator::OtherChoice choice;
  std::variant<EvaluatedDesign, NoPerformance> result;
};

/// One entry for each of actuator::other_choices(design). Pure.
[[nodiscard]] std::vector<ChoiceEffect> choice_effects(const actuator::Design& design, const OperatingPoint& point);

}  // namespace coilwright::simulation
