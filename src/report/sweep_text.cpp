#include "coilwright/report/sweep_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

Section leaders_section(const formats::SweepReport& report) {
  const Study& study = report.study;
  const std::span<const sizing::Leader> leaders = report.leaders;
  TableBlock block{.caption =
                       "Of each configuration the best design in each objective; where none keeps every limit, "
                       "the one that is nearest to it"};
  std::vector<std::string>& header = block.table.header;
  for (const sizing::StudyVariable& variable : study.variables) header.push_back(name_of(variable));
  for (const sizing::StudyObjective& each : study.objectives)
    if (!formats::is_variable(study, each.quantity.name)) header.push_back(each.quantity.name);
  block.align.assign(header.size(), right);
  block.align.push_back(left);
  header.emplace_back("best for");
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
    block.table.rows.push_back(std::move(row));
  }
  Section section{.id = "best", .title = "The best designs"};
  if (!block.table.rows.empty()) section.blocks.emplace_back(std::move(block));
  return section;
}

// The best value of an objective over all configurations, and its design; empty where none keeps every limit.
std::string best_sentence(const formats::SweepReport& report, std::size_t objective) {
  const sizing::StudyObjective& wanted = report.study.objectives[objective];
  const bool largest = wanted.sense == sizing::Sense::maximise;
  const auto value = [&](const sizing::Leader& each) { return each.design.evaluation.objectives[objective]; };
  const sizing::Leader* best = nullptr;
  for (const sizing::Leader& each : report.leaders) {
    if (each.objective != objective || !sizing::is_feasible(each.design.evaluation)) continue;
    if (best == nullptr || (largest ? value(each) > value(*best) : value(each) < value(*best))) best = &each;
  }
  if (best == nullptr) return {};
  std::vector<std::string> parts;
  const std::vector<std::string> values = variable_texts(report.study, best->design.point);
  for (std::size_t i = 0; i < values.size(); ++i)
    parts.push_back(fmt::format("{} {}", name_of(report.study.variables[i]), values[i]));
  return fmt::format("The {} {} is {}: {}. ", largest ? "largest" : "smallest", wanted.quantity.name,
                     short_number(value(*best)), fmt::join(parts, ", "));
}

}  // namespace

Document document_of(const formats::SweepReport& report) {
  const Study& study = report.study;
  std::vector<std::string> wanted;
  for (const sizing::StudyObjective& each : study.objectives) wanted.push_back(objective_text(each));
  Document out{.title = fmt::format("{}: {}", study.name, fmt::join(wanted, ", ")),
               .cautions = cautions_of_parts(study, report.broken, "the best designs",
                                             sizing::feasible_designs(report.leaders).size()),
               .sections = {leaders_section(report)}};
  for (std::size_t i = 0; i < study.objectives.size(); ++i) out.verdict += best_sentence(report, i);
  out.verdict +=
      fmt::format("{} of {} designs evaluated{}; {} keep every limit.", report.evaluated, report.designs,
                  report.sample ? fmt::format(" (those that differ of {} drawn: {}, seed {})", report.sample->drawn,
                                              sizing::name_of(report.sample->sampling), report.sample->seed)
                                : "",
                  report.ok);
  if (report.sample) out.verdict += " Better designs may lie between those of a sample.";
  if (report.evaluated < report.designs)
    out.cautions.insert(out.cautions.begin(), "INTERRUPTED: the run may find better designs; --resume goes on.\n");
  return out;
}

}  // namespace coilwright::report
