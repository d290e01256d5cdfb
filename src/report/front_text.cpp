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

Section ends_section(const Study& study, const ParetoResult& result) {
  TableBlock block{.caption = "Designs of the front", .table = {.header = {""}}, .align = {left}};
  for (const StudyVariable& variable : study.variables) block.table.header.push_back(name_of(variable));
  for (const StudyObjective& objective : study.objectives) block.table.header.emplace_back(objective.quantity.name);
  const auto add = [&](std::string title, const Record& record) {
    std::vector<std::string> row{std::move(title)};
    for (std::string& text : variable_texts(study, record.point)) row.push_back(std::move(text));
    for (const double value : record.evaluation.objectives) row.push_back(short_number(value));
    block.table.rows.push_back(std::move(row));
  };
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    add("best " + study.objectives[i].quantity.name, result.front[formats::end_of(result, i)]);
  add("middle", result.front[formats::middle_of(result)]);
  return {.id = "ends", .title = "The ends of the front, and its middle", .blocks = {std::move(block)}};
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

Section nearest_section(const Study& study, const ParetoResult& result) {
  Section section{.id = "ends", .title = "The least infeasible design"};
  if (!result.least_infeasible) return section;
  TableBlock block{.caption = "Variables of the design",
                   .table = {.header = {"variable", "value"}},
                   .align = {left, right},
                   .headed = false};
  const std::vector<std::string> values = variable_texts(study, result.least_infeasible->point);
  for (std::size_t i = 0; i < values.size(); ++i) block.table.rows.push_back({name_of(study.variables[i]), values[i]});
  section.blocks = {std::move(block),
                    Lines{fmt::format("It is not feasible: {}\n",
                                      reasons_for_infeasibility(study, result.least_infeasible->evaluation))}};
  return section;
}

std::string verdict_of(const Study& study, const ParetoResult& result) {
  if (result.front.empty())
    return result.least_infeasible ? "No design that was found keeps every limit." : "No design was evaluated.";
  std::vector<std::string_view> names;
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < study.objectives.size(); ++i) {
    const auto [least, most] = std::ranges::minmax_element(
        result.front, {}, [i](const Record& each) { return each.evaluation.objectives[i]; });
    names.push_back(study.objectives[i].quantity.name);
    ranges.push_back(fmt::format("{} from {} to {}", names.back(), short_number(least->evaluation.objectives[i]),
                                 short_number(most->evaluation.objectives[i])));
  }
  return fmt::format(
      "{} designs trade {} against each other: {}. None of them is beaten in every objective by another one that was "
      "found.",
      result.front.size(), fmt::join(names, " and "), fmt::join(ranges, ", "));
}

}  // namespace

Document document_of(const Study& study, const ParetoResult& result, std::span<const BrokenPartLimit> broken) {
  std::vector<std::string> wanted;
  for (const StudyObjective& objective : study.objectives) wanted.push_back(objective_text(objective));
  Document out{.title = fmt::format("{}: {}", study.name, fmt::join(wanted, ", ")),
               .verdict = verdict_of(study, result),
               .cautions = cautions_of_parts(study, broken, "designs of this front", result.front.size())};
  if (result.stop_reason == StopReason::interrupted)
    out.cautions.insert(out.cautions.begin(), "INTERRUPTED: the search may find better; --resume goes on.\n");
  const std::string end = fmt::format(
      "{} designs on the front. The search ended because {}. It evaluated {} designs: {}.{}\n", result.front.size(),
      meaning_of(result.stop_reason), result.evaluations, to_text(formats::counts_of(result.archive)),
      late_gain_text(end_of(result.stop_reason, result.archive, result.evaluations)));
  out.sections = {
      result.front.empty() ? nearest_section(study, result) : ends_section(study, result),
      {.id = "convergence", .title = "The search", .blocks = {Lines{end + absent_configurations(study, result)}}}};
  return out;
}

}  // namespace coilwright::report
