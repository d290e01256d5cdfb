#include "coilwright/report/sweep_text.hpp"

#include <fmt/format.h>

#include <span>
#include <utility>
#include <vector>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/text_table.hpp"
#include "report/study_parts.hpp"

namespace coilwright::report {
namespace {

using sizing::Study;
using sizing::SweptDesign;
using enum TextTable::Align;

// The objectives in which the design at `first` is best, also where the leaders after it are the same design; for an
// infeasible design what it violates.
std::string best_for(const Study& study, std::span<const sizing::Leader> leaders, std::size_t first) {
  const SweptDesign& design = leaders[first].design;
  if (!sizing::is_feasible(design.evaluation))
    return "none is feasible; the nearest: " + reasons_for_infeasibility(study, design.evaluation);
  std::string text;
  for (std::size_t i = first; i < leaders.size() && leaders[i].design.index == design.index; ++i)
    text += (text.empty() ? "" : ", ") + study.objectives[leaders[i].objective].quantity.name;
  return text;
}

}  // namespace

std::string to_text(const formats::SweepReport& report) {
  const auto& [study, designs, evaluated, ok, leaders, broken, sample, keep, totals] = report;
  TextTable table;
  std::vector<std::string> header;
  for (const sizing::StudyVariable& variable : study.variables) header.push_back(name_of(variable));
  for (const sizing::StudyObjective& each : study.objectives)
    if (!formats::is_variable(study, each.quantity.name)) header.push_back(each.quantity.name);
  header.emplace_back("best for");
  table.row(std::move(header));
  for (std::size_t k = 0; k < leaders.size(); ++k) {
    const SweptDesign& design = leaders[k].design;
    if (k > 0 && leaders[k - 1].design.index == design.index) continue;
    std::vector<std::string> row = variable_texts(study, design.point);
    const sizing::Evaluation& evaluation = design.evaluation;
    for (std::size_t i = 0; i < study.objectives.size(); ++i) {
      if (formats::is_variable(study, study.objectives[i].quantity.name)) continue;
      row.push_back(evaluation.failure.empty() ? short_number(evaluation.objectives[i]) : "-");
    }
    row.push_back(best_for(study, leaders, k));
    table.row(std::move(row));
  }
  std::vector<TextTable::Align> align(table.columns() - 1, right);
  align.push_back(left);
  return table.text(0, std::move(align)) +
         fmt::format("\n{} of {} designs evaluated{}; {} keep every limit.\n", evaluated, designs,
                     sample ? fmt::format(" (those that differ of {} drawn: {}, seed {})", sample->drawn,
                                          sizing::name_of(sample->sampling), sample->seed)
                            : "",
                     ok) +
         warning_of_parts(study, broken, "the best designs", sizing::feasible_designs(leaders).size());
}

}  // namespace coilwright::report
