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

CsvCell cell_of(const std::vector<std::optional<double>>& quantities, std::size_t index) {
  return index < quantities.size() && quantities[index] ? CsvCell(*quantities[index]) : CsvCell();
}

}  // namespace

void write_evaluations(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> records) {
  const std::vector<std::size_t> beside = objectives_beside_the_table(study);
  std::vector<std::string> names;
  add_variable_names(study, names);
  names.insert(names.end(), {"evaluation", "status"});
  add_quantity_names(study, names);
  for (const std::size_t i : beside) names.push_back(study.objectives[i].quantity.name);
  add_margin_names(study, names);
  names.emplace_back("reason");
  CsvWriter csv(out, std::move(names));
  Cells cells;
  for (const sizing::Record& record : records) {
    const sizing::Evaluation& evaluation = record.evaluation;
    cells.clear();
    add_variables(study, record.point, cells);
    cells.emplace_back(static_cast<std::int64_t>(record.number));
    cells.emplace_back(status_of(evaluation));
    add_quantities(study, evaluation, cells);
    for (const std::size_t i : beside)
      cells.push_back(evaluation.failure.empty() ? CsvCell(evaluation.objectives[i]) : CsvCell());
    add_margins(study, evaluation, cells);
    cells.emplace_back(evaluation.failure);
    csv.row(cells);
  }
}

void write_front(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> front) {
  std::vector<std::string> names;
  add_variable_names(study, names);
  add_objective_names(study, names);
  add_margin_names(study, names);
  const std::vector<std::size_t> further = quantities_beside_the_objectives(study);
  for (const std::size_t i : further) names.push_back(study.quantities[i].name);
  CsvWriter csv(out, std::move(names));
  Cells cells;
  for (const sizing::Record& record : front) {
    cells.clear();
    add_variables(study, record.point, cells);
    add_objectives(study, record.evaluation, cells);
    add_margins(study, record.evaluation, cells);
    for (const std::size_t i : further) cells.push_back(cell_of(record.evaluation.quantities, i));
    csv.row(cells);
  }
}

}  // namespace coilwright::formats
