#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {

/// The figures for which an actuator is usually built. They are compared under every other assumption.
inline constexpr std::array<std::string_view, 5> main_figures = {"peak_bending_speed_deg_s", "steady_angle_deg",
                                                                 "grasp_force_N", "damping_ratio", "thermal_load"};

/// Relative change of a figure from which on an assumption matters for it.
inline constexpr double change_that_matters = 0.02;

/// The figures of a design at an operating point if one assumption is otherwise.
struct ChoiceEffect {
  actuator::OtherChoice choice;
  std::variant<EvaluatedDesign, NoPerformance> result;
  double change{};  ///< of the main figure that changes most, over its value as taken; 1 where one appears or vanishes
  bool breaks{};    ///< whether it breaks an unconditional limit of a part that `taken` keeps, or has no performance

  [[nodiscard]] bool matters() const noexcept { return breaks || change >= change_that_matters; }
};

/// One entry for each of actuator::other_choices() and other_numbers() of the design, at its operating point: subjects
/// with a broken limit first, then by the largest change, each with its entries together. Pure.
[[nodiscard]] std::vector<ChoiceEffect> choice_effects(const DesignView& taken);

}  // namespace coilwright::simulation
