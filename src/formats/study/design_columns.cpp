#include "coilwright/formats/study/design_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

using namespace text;
using sizing::Evaluation;
using sizing::Limit;
using sizing::Study;

std::string_view status_of(const Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return "failed";
  return sizing::is_feasible(evaluation) ? "ok" : "infeasible";
}

std::string margin_column(const Limit& limit) {
  const std::string_view name = limit.quantity.name, own_unit = limit.quantity.unit;
  const std::string_view side = limit.side == Limit::Side::at_most ? "max" : "min";
  std::string_view quantity = name;
  if (!own_unit.empty()) {
    quantity.remove_suffix(own_unit.size() + 1);
  } else if (const auto split = units::split_unit(name)) {
    quantity = split->quantity;
  }
  const std::string_view unit = difference_unit(limit.quantity);
  return fmt::format("{}_{}_margin{}{}", quantity, side, unit.empty() ? "" : "_", unit);
}

std::string_view difference_unit(const simulation::ResultQuantity& quantity) {
  return quantity.unit.empty() ? units::difference_unit(quantity.name).suffix : std::string_view(quantity.unit);
}

bool is_variable(const Study& study, std::string_view name) {
  return std::ranges::any_of(study.variables, [name](const auto& variable) { return name_of(variable) == name; });
}

double margin_of(const Limit& limit, double constraint) {
  return -constraint * scale_of(limit) + 0.0;  // + 0.0: a margin of zero has no sign
}

double value_behind(const Limit& limit, double constraint) {
  const double margin = margin_of(limit, constraint);
  return limit.side == Limit::Side::at_most ? limit.value - margin : limit.value + margin;
}

void add_variable_names(const Study& study, std::vector<std::string>& names) {
  for (const sizing::StudyVariable& variable : study.variables) names.push_back(name_of(variable));
}

void add_variables(const Study& study, std::span<const double> point, Cells& cells) {
  for (std::size_t i = 0; i < point.size(); ++i)
    std::visit([&cells](const auto& value) { cells.emplace_back(value); }, value_at(study.variables[i], point[i]));
}

void add_objective_names(const Study& study, std::vector<std::string>& names) {
  for (const sizing::StudyObjective& objective : study.objectives)
    if (!is_variable(study, objective.quantity.name)) names.emplace_back(objective.quantity.name);
}

void add_objectives(const Study& study, const Evaluation& evaluation, Cells& cells) {
  for (std::size_t i = 0; i < study.objectives.size(); ++i) {
    if (is_variable(study, study.objectives[i].quantity.name)) continue;
    cells.push_back(evaluation.failure.empty() ? CsvCell(evaluation.objectives[i]) : CsvCell());
  }
}

void add_quantity_names(const Study& study, std::vector<std::string>& names) {
  for (const simulation::ResultQuantity& quantity : study.quantities)
    if (!is_variable(study, quantity.name)) names.push_back(quantity.name);
}

void add_quantities(const Study& study, const Evaluation& evaluation, Cells& cells) {
  for (std::size_t i = 0; i < study.quantities.size(); ++i) {
    if (is_variable(study, study.quantities[i].name)) continue;
    const bool there = !evaluation.quantities.empty() && evaluation.quantities[i].has_value();
    cells.push_back(there ? CsvCell(*evaluation.quantities[i]) : CsvCell());
  }
}

void add_margin_names(const Study& study, std::vector<std::string>& names) {
  for (const Limit& limit : study.limits) names.push_back(margin_column(limit));
}

void add_margins(const Study& study, const Evaluation& evaluation, Cells& cells) {
  for (std::size_t i = 0; i < study.limits.size(); ++i)
    cells.push_back(evaluation.failure.empty() ? CsvCell(margin_of(study.limits[i], evaluation.constraints[i]))
                                               : CsvCell());
}

}  // namespace coilwright::formats
