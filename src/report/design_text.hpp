#pragma once

#include <span>
#include <string>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::report {

/// A variable's value at a coordinate, to read.
[[nodiscard]] std::string value_text(const sizing::StudyVariable& variable, double coordinate);

/// The variables of a point, in the order of the study.
[[nodiscard]] std::vector<std::string> variable_texts(const sizing::Study& study, std::span<const double> point);

/// "maximise peak_bending_speed_deg_s".
[[nodiscard]] std::string objective_text(const sizing::StudyObjective& objective);

/// The failure, or the limits that are broken and by how much, worst first.
[[nodiscard]] std::string what_is_in_the_way(const sizing::Study& study, const sizing::Evaluation& evaluation);

}  // namespace coilwright::report
