#include "coilwright/report/sweep_table.hpp"

#include <cmath>
#include <utility>

#include "report/design_columns.hpp"
#include "report/design_text.hpp"
#include "report/text_table.hpp"

namespace coilwright::report {
namespace {

using sizing::Study;
using sizing::SweptDesign;

void add_names(const Study& study, std::vector<std::string>& names) {
  add_variable_names(study, names);
  names.emplace_back("status");
  for (const sizing::Quantity& quantity : sizing::quantities())
    if (!is_variable(study, quantity.name)) names.emplace_back(quantity.name);
  add_margin_names(study, names);
  names.emplace_back("reason");
}

void add_cells(const Study& study, const SweptDesign& design, Cells& cells) {
  add_variables(study, design.point, cells);
  cells.emplace_back(status_of(design.evaluation));
  for (std::size_t i = 0; i < sizing::quantities().size(); ++i) {
    if (is_variable(study, sizing::quantities()[i].name)) continue;
    const bool there = !design.quantities.empty() && design.quantities[i] && std::isfinite(*design.quantities[i]);
    cells.push_back(there ? CsvCell(*design.quantities[i]) : CsvCell());
  }
  add_margins(study, design.evaluation, cells);
  cells.emplace_back(design.evaluation.failure);
}

std::vector<std::string> names_of(const Study& study) {
  std::vector<std::string> names;
  add_names(study, names);
  return names;
}

std::string verdict(const Study& study, const sizing::Leader& leader) {
  if (sizing::is_feasible(leader.design.evaluation))
    return std::string(study.objectives[leader.objective].quantity->name);
  return "nothing feasible; nearest: " + what_is_in_the_way(study, leader.design.evaluation);
}

}  // namespace

SweepTable::SweepTable(std::ostream& out, const Study& study) : study_(&study), csv_(out, names_of(study)) {}

void SweepTable::row(const SweptDesign& design) {
  cells_.clear();
  add_cells(*study_, design, cells_);
  csv_.row(cells_);
}

void write_leaders(std::ostream& out, const Study& study, std::span<const sizing::Leader> leaders) {
  std::vector<std::string> names{"best_for"};
  add_names(study, names);
  CsvWriter csv(out, std::move(names));
  for (const sizing::Leader& leader : leaders) {
    Cells cells{CsvCell(study.objectives[leader.objective].quantity->name)};
    add_cells(study, leader.design, cells);
    csv.row(cells);
  }
}

std::string leaders_text(const Study& study, std::span<const sizing::Leader> leaders) {
  TextTable table;
  std::vector<std::string> header;
  add_variable_names(study, header);
  add_objective_names(study, header);
  header.emplace_back("best for");
  table.row(std::move(header));
  for (const sizing::Leader& leader : leaders) {
    std::vector<std::string> row = variable_texts(study, leader.design.point);
    const sizing::Evaluation& evaluation = leader.design.evaluation;
    for (std::size_t i = 0; i < study.objectives.size(); ++i) {
      if (is_variable(study, study.objectives[i].quantity->name)) continue;
      row.push_back(evaluation.failure.empty() ? short_number(evaluation.objectives[i]) : "-");
    }
    row.push_back(verdict(study, leader));
    table.row(std::move(row));
  }
  std::vector<TextTable::Align> align(table.columns() - 1, TextTable::Align::right);
  align.push_back(TextTable::Align::left);
  return table.text(0, std::move(align));
}

}  // namespace coilwright::report
