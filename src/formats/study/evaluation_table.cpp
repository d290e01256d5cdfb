#include "coilwright/formats/study/evaluation_table.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/study/design_columns.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

// Of a program's own study: objectives that its table of quantities lacks.
std::vector<std::size_t> objectives_beside_the_table(const sizing::Study& study) {
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < study.objectives.size(); ++i) {
    const std::string& name = study.objectives[i].quantity.name;
    if (!is_variable(study, name) && study.quantities.find(name) == nullptr) beside.push_back(i);
  }
  return beside;
}

// What a row of a front has not said yet.
std::vector<std::size_t> quantities_beside_the_objectives(const sizing::Study& study) {
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < study.quantities.size(); ++i) {
    const std::string& name = study.quantities[i].name;
    const bool said = std::ranges::any_of(
        study.objectives, [&](const sizing::StudyObjective& each) { return each.quantity.name == name; });
    if (!said && !is_variable(study, name)) beside.push_back(i);
  }
  return beside;
}

void write_records(std::ostream& out, DesignColumns columns, std::span<const sizing::Record> records) {
  DesignTable table(out, std::move(columns));
  for (const sizing::Record& record : records)
    table.row({.point = record.point, .evaluation = record.evaluation, .number = record.number});
}

}  // namespace

void write_evaluations(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> records) {
  DesignColumns columns;
  add_variables(study, columns);
  columns.push_back({"evaluation", [](const DesignRow& row) { return CsvCell(row.number); }});
  add_status(columns);
  add_quantities(study, columns);
  for (const std::size_t i : objectives_beside_the_table(study)) add_objective(study, i, columns);
  add_margins(study, columns);
  add_reason(columns);
  write_records(out, std::move(columns), records);
}

void write_front(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> front) {
  DesignColumns columns;
  add_variables(study, columns);
  add_objectives(study, columns);
  add_margins(study, columns);
  for (const std::size_t i : quantities_beside_the_objectives(study)) add_quantity(study, i, columns);
  write_records(out, std::move(columns), front);
}

}  // namespace coilwright::formats
