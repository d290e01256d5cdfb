#include "coilwright/report/sweep_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "report/design_columns.hpp"
#include "report/design_text.hpp"
#include "report/text_table.hpp"

namespace coilwright::report {
namespace {

using namespace text;
using sizing::Study;
using sizing::SweptDesign;

void add_names(const Study& study, std::vector<std::string>& names) {
  add_variable_names(study, names);
  names.emplace_back("status");
  for (const simulation::ResultQuantity& quantity : study.quantities)
    if (!is_variable(study, quantity.name)) names.emplace_back(quantity.name);
  add_margin_names(study, names);
  names.emplace_back("reason");
}

void add_cells(const Study& study, const SweptDesign& design, Cells& cells) {
  add_variables(study, design.point, cells);
  cells.emplace_back(status_of(design.evaluation));
  for (std::size_t i = 0; i < study.quantities.size(); ++i) {
    if (is_variable(study, study.quantities[i].name)) continue;
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

// What the design at `first` is best for, and where the leaders after it are the same design: that too.
std::string verdict(const Study& study, std::span<const sizing::Leader> leaders, std::size_t first) {
  const SweptDesign& design = leaders[first].design;
  if (!sizing::is_feasible(design.evaluation))
    return "nothing feasible; nearest: " + what_is_in_the_way(study, design.evaluation);
  std::string text;
  for (std::size_t i = first; i < leaders.size() && leaders[i].design.index == design.index; ++i)
    text += (text.empty() ? "" : ", ") + study.objectives[leaders[i].objective].quantity.name;
  return text;
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
    Cells cells{CsvCell(study.objectives[leader.objective].quantity.name)};
    add_cells(study, leader.design, cells);
    csv.row(cells);
  }
}

Json to_json(const SweepAnswer& answer) {
  Json best = Json::array();
  for (const sizing::Leader& leader : answer.leaders) {
    const sizing::Evaluation& evaluation = leader.design.evaluation;
    Json entry = Json::object({{"best_for", answer.study.objectives[leader.objective].quantity.name},
                               {"status", status_of(evaluation)},
                               {"variables", variables_json(answer.study, leader.design.point)},
                               {"objectives", objectives_json(answer.study, evaluation)},
                               {"constraints", constraints_json(answer.study, evaluation)}});
    if (!evaluation.failure.empty()) entry.set("reason", evaluation.failure);
    best.add(std::move(entry));
  }
  return Json::object({{"command", "sweep"},
                       {"study", answer.study.name},
                       {"designs", answer.designs},
                       {"evaluated", answer.evaluated},
                       {"ok", answer.ok},
                       {"best", std::move(best)}});
}

std::string to_text(const SweepAnswer& answer) {
  const auto& [study, designs, evaluated, ok, leaders] = answer;
  TextTable table;
  std::vector<std::string> header;
  add_variable_names(study, header);
  add_objective_names(study, header);
  header.emplace_back("best for");
  table.row(std::move(header));
  for (std::size_t k = 0; k < leaders.size(); ++k) {
    const SweptDesign& design = leaders[k].design;
    if (k > 0 && leaders[k - 1].design.index == design.index) continue;
    std::vector<std::string> row = variable_texts(study, design.point);
    const sizing::Evaluation& evaluation = design.evaluation;
    for (std::size_t i = 0; i < study.objectives.size(); ++i) {
      if (is_variable(study, study.objectives[i].quantity.name)) continue;
      row.push_back(evaluation.failure.empty() ? short_number(evaluation.objectives[i]) : "-");
    }
    row.push_back(verdict(study, leaders, k));
    table.row(std::move(row));
  }
  std::vector<TextTable::Align> align(table.columns() - 1, TextTable::Align::right);
  align.push_back(TextTable::Align::left);
  return table.text(0, std::move(align)) +
         fmt::format("\n{} of {} designs evaluated; {} keep every limit.\n", evaluated, designs, ok);
}

}  // namespace coilwright::report
