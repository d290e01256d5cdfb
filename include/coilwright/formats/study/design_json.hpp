#pragma once

#include <span>

#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// A variable's value at a coordinate: a word, a whole number or a number in the unit of the variable's name.
[[nodiscard]] text::Json value_json(const sizing::StudyVariable& variable, double coordinate);

/// The variables of a point, in the order of the study.
[[nodiscard]] text::Json variables_json(const sizing::Study& study, std::span<const double> point);

/// {"peak_bending_speed_deg_s": 1708.1, ...}; null for a failed design.
[[nodiscard]] text::Json objectives_json(const sizing::Study& study, const sizing::Evaluation& evaluation);

/// [{"quantity": "mass_g", "at_most": 70, "value": 69.2, "margin": 0.8}, ...]; values null for a failed design.
[[nodiscard]] text::Json constraints_json(const sizing::Study& study, const sizing::Evaluation& evaluation);

}  // namespace coilwright::formats
