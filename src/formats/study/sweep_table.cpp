#include "coilwright/formats/study/sweep_table.hpp"

#include <utility>

#include "coilwright/formats/study/design_columns.hpp"
#include "coilwright/formats/study/design_json.hpp"
#include "coilwright/formats/study/search_json.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using sizing::Study;
using sizing::SweptDesign;

void add_names(const Study& study, std::vector<std::string>& names) {
  add_variable_names(study, names);
  names.emplace_back("status");
  add_quantity_names(study, names);
  add_margin_names(study, names);
  names.emplace_back("reason");
}

void add_cells(const Study& study, const SweptDesign& design, Cells& cells) {
  add_variables(study, design.point, cells);
  cells.emplace_back(status_of(design.evaluation));
  add_quantities(study, design.evaluation, cells);
  add_margins(study, design.evaluation, cells);
  cells.emplace_back(design.evaluation.failure);
}

std::vector<std::string> names_of(const Study& study) {
  std::vector<std::string> names;
  add_names(study, names);
  return names;
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

Json to_json(const SweepReport& report) {
  Json best = Json::array();
  for (const sizing::Leader& leader : report.leaders) {
    const sizing::Evaluation& evaluation = leader.design.evaluation;
    Json entry = Json::object({{"best_for", report.study.objectives[leader.objective].quantity.name},
                               {"status", status_of(evaluation)},
                               {"variables", variables_json(report.study, leader.design.point)},
                               {"objectives", objectives_json(report.study, evaluation)},
                               {"constraints", constraints_json(report.study, evaluation)}});
    if (!evaluation.failure.empty()) entry.set("reason", evaluation.failure);
    best.add(std::move(entry));
  }
  return Json::object({{"command", "sweep"},
                       {"study", report.study.name},
                       {"objectives", objectives_asked(report.study)},
                       {"designs", report.designs},
                       {"evaluated", report.evaluated},
                       {"ok", report.ok},
                       {"best", std::move(best)},
                       {"broken_part_limits", to_json(report.broken)}});
}

}  // namespace coilwright::formats
