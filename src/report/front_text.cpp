#include "coilwright/report/front_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/study/front_json.hpp"
#include "coilwright/report/simulation/text_table.hpp"
#include "report/study_parts.hpp"

namespace coilwright::report {
namespace {

using namespace sizing;
using enum TextTable::Align;

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
    add("best " + study.objectives[i].quantity.name, result.front[formats::end_of(result, i)]);
  add("middle", result.front[formats::middle_of(result)]);
  return table.text(0, {left});
}

// A reader who let four configurations vary looks for all of them.
std::string absent_configurations(const Study& study, const ParetoResult& result) {
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const auto* variable = std::get_if<LayoutVariable>(&study.variables[i]);
    if (variable == nullptr) continue;
    std::vector<std::string_view> absent;
    for (std::size_t k = 0; k < variable->values.size(); ++k) {
      const auto is_that = [&](const Record& record) { return record.point[i] == static_cast<double>(k); };
      if (std::ranges::none_of(result.front, is_that)) absent.push_back(variable->values[k].name);
    }
    if (!absent.empty() && !result.front.empty())
      return fmt::format("No design of {} {} is on it: each that was found is beaten or breaks a limit.\n",
                         variable->name, fmt::join(absent, ", "));
  }
  return {};
}

std::string nearest_text(const Study& study, const ParetoResult& result) {
  if (!result.least_infeasible) return "No design was evaluated.\n";
  TextTable table;
  const std::vector<std::string> values = variable_texts(study, result.least_infeasible->point);
  for (std::size_t i = 0; i < values.size(); ++i) table.row({name_of(study.variables[i]), values[i]});
  return "No design that was found keeps every limit. The least infeasible one\n" + table.text(2, {left, right}) +
         fmt::format("It is not feasible: {}\n", reasons_for_infeasibility(study, result.least_infeasible->evaluation));
}

}  // namespace

std::string to_text(const Study& study, const ParetoResult& result, std::span<const BrokenPartLimit> broken) {
  std::string text = study.name + ":";
  for (const StudyObjective& objective : study.objectives)
    text += (&objective == &study.objectives.front() ? " " : ", ") + objective_text(objective);
  text += "\n\n" + (result.front.empty() ? nearest_text(study, result) : table_of(study, result));
  return text +
         fmt::format("\n{} designs on the front. The search ended because {}. It evaluated {} designs: {}.{}\n",
                     result.front.size(), meaning_of(result.stop_reason), result.evaluations,
                     to_text(formats::counts_of(result.archive)),
                     late_gain_text(end_of(result.stop_reason, result.archive, result.evaluations))) +
         absent_configurations(study, result) +
         warning_of_parts(study, broken, "designs of this front", result.front.size());
}

}  // namespace coilwright::report
