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

/// Why a design is not feasible: its failure, or the limits that it violates and by how much, worst first. Empty for a
/// feasible design.
[[nodiscard]] std::string reasons_for_infeasibility(const sizing::Study& study, const sizing::Evaluation& evaluation);

}  // namespace coilwright::report
