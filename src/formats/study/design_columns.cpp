#include "coilwright/formats/study/design_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

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

void add_variables(const Study& study, DesignColumns& columns) {
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    columns.push_back({name_of(study.variables[i]), [&variable = study.variables[i], i](const DesignRow& row) {
                         return std::visit([](const auto& value) { return CsvCell(value); },
                                           value_at(variable, row.point[i]));
                       }});
}

void add_objective(const Study& study, std::size_t index, DesignColumns& columns) {
  columns.push_back({study.objectives[index].quantity.name, [index](const DesignRow& row) {
                       const Evaluation& evaluation = row.evaluation;
                       return evaluation.failure.empty() ? CsvCell(evaluation.objectives[index]) : CsvCell();
                     }});
}

void add_objectives(const Study& study, DesignColumns& columns) {
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    if (!is_variable(study, study.objectives[i].quantity.name)) add_objective(study, i, columns);
}

void add_quantity(const Study& study, std::size_t index, DesignColumns& columns) {
  columns.push_back({study.quantities[index].name, [index](const DesignRow& row) {
                       const auto& values = row.evaluation.quantities;
                       return index < values.size() ? CsvCell(values[index]) : CsvCell();
                     }});
}

void add_quantities(const Study& study, DesignColumns& columns) {
  for (std::size_t i = 0; i < study.quantities.size(); ++i)
    if (!is_variable(study, study.quantities[i].name)) add_quantity(study, i, columns);
}

void add_margins(const Study& study, DesignColumns& columns) {
  for (std::size_t i = 0; i < study.limits.size(); ++i)
    columns.push_back({margin_column(study.limits[i]), [&limit = study.limits[i], i](const DesignRow& row) {
                         const Evaluation& evaluation = row.evaluation;
                         return evaluation.failure.empty() ? CsvCell(margin_of(limit, evaluation.constraints[i]))
                                                           : CsvCell();
                       }});
}

void add_status(DesignColumns& columns) {
  columns.push_back({"status", [](const DesignRow& row) { return CsvCell(status_of(row.evaluation)); }});
}

void add_reason(DesignColumns& columns) {
  columns.push_back({"reason", [](const DesignRow& row) { return CsvCell(row.evaluation.failure); }});
}

namespace {

std::vector<std::string> names_of(const DesignColumns& columns) {
  std::vector<std::string> names;
  for (const DesignColumn& column : columns) names.push_back(column.name);
  return names;
}

}  // namespace

DesignTable::DesignTable(std::ostream& out, DesignColumns columns)
    : columns_(std::move(columns)), csv_(out, names_of(columns_)) {}

void DesignTable::row(const DesignRow& row) {
  cells_.clear();
  for (const DesignColumn& column : columns_) cells_.push_back(column.cell(row));
  csv_.row(cells_);
}

}  // namespace coilwright::formats
