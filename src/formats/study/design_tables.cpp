#include "coilwright/formats/study/design_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
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

namespace {

// A design of a study, as tables have it.
struct DesignRow {
  std::span<const double> point;
  const Evaluation& evaluation;
  std::size_t number{};  // its place in the order of evaluation
  std::string_view proposed_by{};
  std::string_view best_for{};  // the objective in which it leads
};

// A column of a table of designs: its name, and what it has of each.
struct DesignColumn {
  std::string name;
  std::function<CsvCell(const DesignRow&)> cell;
};
using DesignColumns = std::vector<DesignColumn>;

DesignColumns variables_of(const Study& study) {
  DesignColumns columns;
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    columns.push_back({name_of(study.variables[i]), [&variable = study.variables[i], i](const DesignRow& row) {
                         return std::visit([](const auto& value) { return CsvCell(value); },
                                           value_at(variable, row.point[i]));
                       }});
  return columns;
}

// Empty for a failed design.
void add_objective(const Study& study, std::size_t index, DesignColumns& columns) {
  columns.push_back({study.objectives[index].quantity.name, [index](const DesignRow& row) {
                       const Evaluation& evaluation = row.evaluation;
                       return evaluation.failure.empty() ? CsvCell(evaluation.objectives[index]) : CsvCell();
                     }});
}

// The quantities of the study's table that are no variables too (current_A may be both) and that `left_out` does not
// name; empty where a design has no value.
void add_quantities(const Study& study, DesignColumns& columns,
                    const std::vector<sizing::StudyObjective>& left_out = {}) {
  for (std::size_t i = 0; i < study.quantities.size(); ++i) {
    const std::string& name = study.quantities[i].name;
    const auto has_name = [&](const sizing::StudyObjective& each) { return each.quantity.name == name; };
    if (is_variable(study, name) || std::ranges::any_of(left_out, has_name)) continue;
    columns.push_back({name, [i](const DesignRow& row) {
                         const auto& values = row.evaluation.quantities;
                         return i < values.size() ? CsvCell(values[i]) : CsvCell();
                       }});
  }
}

// In the units of their quantities, negative where a limit is broken; empty for a failed design.
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

void add_columns_of_sweep(const Study& study, DesignColumns& columns) {
  std::ranges::move(variables_of(study), std::back_inserter(columns));
  add_status(columns);
  add_quantities(study, columns);
  add_margins(study, columns);
  add_reason(columns);
}

std::vector<std::string> names_of(const DesignColumns& columns) {
  std::vector<std::string> names;
  for (const DesignColumn& column : columns) names.push_back(column.name);
  return names;
}

// Writes the header, and returns what writes the row of one design.
auto table_of(std::ostream& out, DesignColumns columns) {
  return [csv = CsvWriter(out, names_of(columns)), columns = std::move(columns)](const DesignRow& row) mutable {
    std::vector<CsvCell> cells;
    for (const DesignColumn& column : columns) cells.push_back(column.cell(row));
    csv.row(cells);
  };
}

void write_records(std::ostream& out, DesignColumns columns, std::span<const sizing::Record> records) {
  auto write_row = table_of(out, std::move(columns));
  for (const sizing::Record& record : records)
    write_row({.point = record.point,
               .evaluation = record.evaluation,
               .number = record.number,
               .proposed_by = record.proposed_by});
}

}  // namespace

void write_evaluations(std::ostream& out, const Study& study, std::span<const sizing::Record> records) {
  DesignColumns columns = variables_of(study);
  columns.push_back({"evaluation", [](const DesignRow& row) { return CsvCell(row.number); }});
  columns.push_back({"proposed_by", [](const DesignRow& row) { return CsvCell(row.proposed_by); }});
  add_status(columns);
  add_quantities(study, columns);
  // Of a program's own study: objectives that its table of quantities lacks.
  for (std::size_t i = 0; i < study.objectives.size(); ++i) {
    const std::string& name = study.objectives[i].quantity.name;
    if (!is_variable(study, name) && study.quantities.find(name) == nullptr) add_objective(study, i, columns);
  }
  add_margins(study, columns);
  add_reason(columns);
  write_records(out, std::move(columns), records);
}

void write_front(std::ostream& out, const Study& study, std::span<const sizing::Record> front) {
  DesignColumns columns = variables_of(study);
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    if (!is_variable(study, study.objectives[i].quantity.name)) add_objective(study, i, columns);
  add_margins(study, columns);
  add_quantities(study, columns, study.objectives);
  write_records(out, std::move(columns), front);
}

SweepRow write_sweep(std::ostream& out, const Study& study) {
  DesignColumns columns;
  add_columns_of_sweep(study, columns);
  return [write_row = table_of(out, std::move(columns))](const sizing::SweptDesign& design) mutable {
    write_row({.point = design.point, .evaluation = design.evaluation});
  };
}

void write_leaders(std::ostream& out, const Study& study, std::span<const sizing::Leader> leaders) {
  DesignColumns columns{{"best_for", [](const DesignRow& row) { return CsvCell(row.best_for); }}};
  add_columns_of_sweep(study, columns);
  auto write_row = table_of(out, std::move(columns));
  for (const sizing::Leader& leader : leaders)
    write_row({.point = leader.design.point,
               .evaluation = leader.design.evaluation,
               .best_for = study.objectives[leader.objective].quantity.name});
}

}  // namespace coilwright::formats
