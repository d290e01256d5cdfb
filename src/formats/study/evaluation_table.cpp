#include "coilwright/formats/study/evaluation_table.hpp"

#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/study/design_columns.hpp"

namespace coilwright::formats {

using namespace text;

void write_evaluations(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> records) {
  std::vector<std::string> names;
  add_variable_names(study, names);
  names.emplace_back("status");
  add_objective_names(study, names);
  add_margin_names(study, names);
  names.emplace_back("reason");
  CsvWriter csv(out, std::move(names));
  Cells cells;
  for (const sizing::Record& record : records) {
    cells.clear();
    add_variables(study, record.point, cells);
    cells.emplace_back(status_of(record.evaluation));
    add_objectives(study, record.evaluation, cells);
    add_margins(study, record.evaluation, cells);
    cells.emplace_back(record.evaluation.failure);
    csv.row(cells);
  }
}

void write_front(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> front) {
  std::vector<std::string> names;
  add_variable_names(study, names);
  add_objective_names(study, names);
  add_margin_names(study, names);
  CsvWriter csv(out, std::move(names));
  Cells cells;
  for (const sizing::Record& record : front) {
    cells.clear();
    add_variables(study, record.point, cells);
    add_objectives(study, record.evaluation, cells);
    add_margins(study, record.evaluation, cells);
    csv.row(cells);
  }
}

}  // namespace coilwright::formats
