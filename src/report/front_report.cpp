#include "coilwright/report/front_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "report/archive_counts.hpp"
#include "report/design_text.hpp"
#include "report/text_table.hpp"

namespace coilwright::report {
namespace {

using namespace text;
using namespace sizing;

// Hypervolume of the front in its own frame, reference 1.1: how full it is, comparable between runs of one study only.
Json hypervolume_json(const ParetoResult& result) {
  if (result.front.empty()) return nullptr;
  const std::vector<Objectives> points = minimised(result.archive.problem(), result.front);
  return normalised_hypervolume(points, frame_of(points));
}

// The design whose worst objective, ideal to nadir, is least bad.
std::size_t middle_of(const ParetoResult& result) {
  const std::vector<Objectives> points = minimised(result.archive.problem(), result.front);
  const FrontFrame frame = frame_of(points);
  std::size_t middle = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    double worst = 0.0;
    for (std::size_t k = 0; k < points[i].size(); ++k) {
      const double span = frame.nadir[k] - frame.ideal[k];
      if (span > 0.0) worst = std::max(worst, (points[i][k] - frame.ideal[k]) / span);
    }
    if (worst >= least) continue;
    least = worst;
    middle = i;
  }
  return middle;
}

std::size_t end_of(const ParetoResult& result, std::size_t objective) {
  const std::vector<Objectives> points = minimised(result.archive.problem(), result.front);
  const auto best =
      std::ranges::min_element(points, {}, [objective](const Objectives& each) { return each[objective]; });
  return static_cast<std::size_t>(best - points.begin());
}

Json end_json(const Study& study, const Record& record) {
  return Json::object({{"variables", variables_json(study, record.point)},
                       {"objectives", objectives_json(study, record.evaluation)},
                       {"constraints", constraints_json(study, record.evaluation)}});
}

Json least_infeasible_json(const Study& study, const ParetoResult& result) {
  if (!result.least_infeasible) return nullptr;
  Json out = end_json(study, *result.least_infeasible);
  Json violated = Json::array();
  for (const std::string& name : result.violated) violated.add(name);
  out.set("violated", std::move(violated));
  return out;
}

std::string table_of(const Study& study, const ParetoResult& result) {
  TextTable table;
  std::vector<std::string> header{""};
  for (const StudyVariable& variable : study.variables) header.push_back(name_of(variable));
  for (const StudyObjective& objective : study.objectives) header.emplace_back(objective.quantity.name);
  table.row(std::move(header));
  const auto add = [&](std::string title, const Record& record) {
    std::vector<std::string> row{std::move(title)};
    for (std::string& text : variable_texts(study, record.point)) row.push_back(std::move(text));
    for (const double value : record.evaluation.objectives) row.push_back(short_number(value));
    table.row(std::move(row));
  };
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    add("best " + study.objectives[i].quantity.name, result.front[end_of(result, i)]);
  add("middle", result.front[middle_of(result)]);
  return table.text(0, {TextTable::Align::left});
}

std::string nearest_text(const Study& study, const ParetoResult& result) {
  if (!result.least_infeasible) return "Nothing was evaluated.\n";
  TextTable table;
  const std::vector<std::string> values = variable_texts(study, result.least_infeasible->point);
  for (std::size_t i = 0; i < values.size(); ++i) table.row({name_of(study.variables[i]), values[i]});
  return "No design found keeps every limit. The least infeasible one\n" +
         table.text(2, {TextTable::Align::left, TextTable::Align::right}) +
         fmt::format("In the way: {}\n", what_is_in_the_way(study, result.least_infeasible->evaluation));
}

}  // namespace

Json to_json(const Study& study, const ParetoResult& result) {
  Json evaluations = to_json(counts_of(result.archive));
  evaluations.set("total", result.evaluations);
  Json out = result_head("pareto", study, result.stop_reason);
  out.set("evaluations", std::move(evaluations)).set("feasible", !result.front.empty());
  out.set("front_size", result.front.size()).set("hypervolume", hypervolume_json(result));
  Json ends = Json::array();
  if (!result.front.empty())
    for (std::size_t i = 0; i < study.objectives.size(); ++i)
      ends.add(end_json(study, result.front[end_of(result, i)]));
  out.set("ends", std::move(ends));
  out.set("middle", result.front.empty() ? Json(nullptr) : end_json(study, result.front[middle_of(result)]));
  out.set("least_infeasible", least_infeasible_json(study, result));
  return out;
}

std::string to_text(const Study& study, const ParetoResult& result) {
  std::string text = study.name + ":";
  for (const StudyObjective& objective : study.objectives)
    text += (&objective == &study.objectives.front() ? " " : ", ") + objective_text(objective);
  text += "\n\n" + (result.front.empty() ? nearest_text(study, result) : table_of(study, result));
  return text + fmt::format("\n{} designs on the front. Stopped because {}: {} evaluations; {}.\n", result.front.size(),
                            meaning_of(result.stop_reason), result.evaluations, to_text(counts_of(result.archive)));
}

}  // namespace coilwright::report
