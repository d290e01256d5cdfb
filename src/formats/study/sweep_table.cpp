#include "coilwright/formats/study/sweep_table.hpp"

#include <utility>

#include "coilwright/formats/study/design_columns.hpp"
#include "coilwright/formats/study/result_json.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using sizing::Study;
using sizing::SweptDesign;

DesignColumns columns_of(const Study& study, DesignColumns columns = {}) {
  add_variables(study, columns);
  add_status(columns);
  add_quantities(study, columns);
  add_margins(study, columns);
  add_reason(columns);
  return columns;
}

}  // namespace

SweepTable::SweepTable(std::ostream& out, const Study& study) : table_(out, columns_of(study)) {}

void SweepTable::row(const SweptDesign& design) {
  table_.row({.point = design.point, .evaluation = design.evaluation});
}

void write_leaders(std::ostream& out, const Study& study, std::span<const sizing::Leader> leaders) {
  DesignTable table(out, columns_of(study, {{"best_for", [](const DesignRow& row) { return CsvCell(row.best_for); }}}));
  for (const sizing::Leader& leader : leaders)
    table.row({.point = leader.design.point,
               .evaluation = leader.design.evaluation,
               .best_for = study.objectives[leader.objective].quantity.name});
}

Json to_json(const SweepReport& report) {
  Json best = Json::list(report.leaders, [&](const sizing::Leader& leader) {
    const sizing::Evaluation& evaluation = leader.design.evaluation;
    Json entry = Json::object({{"best_for", report.study.objectives[leader.objective].quantity.name},
                               {"status", status_of(evaluation)},
                               {"variables", variables_json(report.study, leader.design.point)},
                               {"objectives", objectives_json(report.study, evaluation)},
                               {"constraints", constraints_json(report.study, evaluation)}});
    if (!evaluation.failure.empty()) entry.set("reason", evaluation.failure);
    return entry;
  });
  Json out = Json::object({{"command", "sweep"},
                           {"study", report.study.name},
                           {"objectives", objectives_asked(report.study)},
                           {"designs", report.designs},
                           {"evaluated", report.evaluated},
                           {"ok", report.ok},
                           {"best", std::move(best)},
                           {"broken_part_limits", to_json(report.broken)}});
  if (const auto& sample = report.sample)
    out.set("sample",
            Json::object(
                {{"sampling", sizing::name_of(sample->sampling)}, {"drawn", sample->drawn}, {"seed", sample->seed}}));
  return out;
}

}  // namespace coilwright::formats
