#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::report {

/// A variable's value at a coordinate, to read and as JSON.
[[nodiscard]] std::string value_text(const sizing::StudyVariable& variable, double coordinate);
[[nodiscard]] text::Json value_json(const sizing::StudyVariable& variable, double coordinate);

/// The variables of a point, in the order of the study.
[[nodiscard]] std::vector<std::string> variable_texts(const sizing::Study& study, std::span<const double> point);
[[nodiscard]] text::Json variables_json(const sizing::Study& study, std::span<const double> point);

/// {"peak_bending_speed_deg_s": 1708.1, ...}; null for a failed design.
[[nodiscard]] text::Json objectives_json(const sizing::Study& study, const sizing::Evaluation& evaluation);

/// [{"quantity": "mass_g", "at_most": 70, "value": 69.2, "margin": 0.8}, ...]; values null for a failed design.
[[nodiscard]] text::Json constraints_json(const sizing::Study& study, const sizing::Evaluation& evaluation);

/// "maximise peak_bending_speed_deg_s".
[[nodiscard]] std::string objective_text(const sizing::StudyObjective& objective);

/// The value that a limit's quantity has, given the constraint's.
[[nodiscard]] double value_behind(const sizing::Limit& limit, double constraint);

/// The failure, or the limits that are broken and by how much, worst first.
[[nodiscard]] std::string what_is_in_the_way(const sizing::Study& study, const sizing::Evaluation& evaluation);

}  // namespace coilwright::report
