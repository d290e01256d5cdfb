#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::formats {

/// A row under construction: the names of its columns were collected in the same order.
using Cells = std::vector<text::CsvCell>;

/// "ok", "infeasible" or "failed".
[[nodiscard]] std::string_view status_of(const sizing::Evaluation& evaluation);

/// Column of a limit's margin: "mass_max_margin_g" for mass_g <= 70, "steady_angle_min_margin_deg" for >=.
[[nodiscard]] std::string margin_column(const sizing::Limit& limit);

/// Suffix of the unit of a difference of two values of a quantity: "K" for degC; empty for a plain number.
[[nodiscard]] std::string_view difference_unit(const simulation::ResultQuantity& quantity);

void add_variable_names(const sizing::Study& study, std::vector<std::string>& names);
void add_variables(const sizing::Study& study, std::span<const double> point, Cells& cells);

/// Objectives that are not variables too (current_A may be both).
void add_objective_names(const sizing::Study& study, std::vector<std::string>& names);
void add_objectives(const sizing::Study& study, const sizing::Evaluation& evaluation, Cells& cells);

/// Every quantity of the study's table that is not a variable too; empty where a design has no value.
void add_quantity_names(const sizing::Study& study, std::vector<std::string>& names);
void add_quantities(const sizing::Study& study, const sizing::Evaluation& evaluation, Cells& cells);

/// Margins in the units of their quantities, negative where a limit is broken; empty for a failed design.
void add_margin_names(const sizing::Study& study, std::vector<std::string>& names);
void add_margins(const sizing::Study& study, const sizing::Evaluation& evaluation, Cells& cells);

/// Whether the study has a variable of that name.
[[nodiscard]] bool is_variable(const sizing::Study& study, std::string_view name);

/// The margin behind a constraint's value, in the unit of its quantity.
[[nodiscard]] double margin_of(const sizing::Limit& limit, double constraint);

/// The value that a limit's quantity has, given the constraint's.
[[nodiscard]] double value_behind(const sizing::Limit& limit, double constraint);

}  // namespace coilwright::formats
