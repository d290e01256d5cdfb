#include "page/result_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/text/number.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {

using text::Node;

namespace {

std::string violations_text(const Node& step) {
  std::vector<std::string> names;
  for (const Node& each : member_of(step, "violates").elements()) names.push_back(cell_of(each));
  return fmt::format("{}", fmt::join(names, ", "));
}

// Of what `size` looks at behind its search.
std::string why_left_out(const Node& result) {
  if (!is_feasible(result)) return "no design keeps every limit";
  return was_interrupted(result) ? "the run was interrupted" : "the answer only was asked for";
}

}  // namespace

Section builds_section(const Node& result, const std::optional<sizing::Yield>& built) {
  Section section{.id = "builds", .title = "What other builds make of it"};
  if (!built) {
    section.blocks.emplace_back(Paragraph{fmt::format("None were made: {}.", why_left_out(result))});
    return section;
  }
  section.blocks.emplace_back(Listing{report::built_text(*built)});
  BarChart chart{
      .id = "built_margins",
      .title = "Margins of the builds",
      .description =
          "How far each limit is from being reached, in per cent of the limit: of the design, of the middle "
          "build, and at both ends of what nine builds in ten lie between. To the left of 0 a limit is broken.",
      .value_title = "margin, %",
      .label_title = "limit",
      .symbols = true};
  Table table{.header = {"quantity", "designed", "5 % of builds below", "half", "95 %", "limit", "kept by, % (95 %)"}};
  for (const sizing::BuiltQuantity& each : built->quantities) {
    const auto cell = [](const std::optional<double>& value) { return value ? short_number(*value) : "none"; };
    const auto percent = [](double share) { return short_number(100.0 * share); };
    table.rows.push_back({each.name, cell(each.nominal), cell(each.p05), cell(each.p50), cell(each.p95),
                          each.limit.empty() ? "" : each.limit.substr(each.limit.find(' ') + 1),
                          each.keeps ? fmt::format("{} ({} to {})", percent(each.keeps->value),
                                                   percent(each.keeps->low), percent(each.keeps->high))
                                     : ""});
    const auto limit = text::number_in(each.limit.substr(each.limit.rfind(' ') + 1));
    if (!limit || *limit == 0.0) continue;
    const double sign = each.limit.find(">=") == std::string::npos ? 1.0 : -1.0;
    for (const auto& [value, group] :
         {std::pair(each.p05, "5 % of builds are below"), std::pair(each.p50, "middle build"),
          std::pair(each.p95, "95 % of builds are below"), std::pair(each.nominal, "designed")})
      if (value)
        chart.bars.push_back(
            {.label = each.limit, .value = 100.0 * sign * (*limit - *value) / std::abs(*limit), .group = group});
  }
  if (!chart.bars.empty()) section.blocks.emplace_back(figure_of(chart));
  section.blocks.emplace_back(TableBlock{.caption = "What the builds are", .table = std::move(table)});
  section.blocks.emplace_back(Paragraph{
      "Which scatter decides: coilwright yield STUDY.json actuator.json --worth 500 says it of each quantity, and "
      "what half of each scatter would bring."});
  return section;
}

Section sensitivity_section(const Node& result) {
  Section section{.id = "sensitivity", .title = "What a change would bring"};
  BarChart chart{.id = "steps",
                 .title = "One step of one variable",
                 .description = "Change of the objective when one variable moves by one step and all others stay.",
                 .value_title = "change of " + objective_of(result).name,
                 .label_title = "step"};
  Table table{.header = {"variable", "from", "to", "change", "breaks"}};
  for (const Node& each : member_of(result, "steps").elements()) {
    const Node change = member_of(each, "objective_change");
    const std::string broken = violations_text(each);
    table.rows.push_back(
        {cell_of(each, "variable"), cell_of(each, "from"), cell_of(each, "to"), cell_of(change), broken});
    if (change.is_null()) continue;
    const bool improves = member_of(each, "improves").boolean();
    chart.bars.push_back(
        {.label = fmt::format("{} {} to {}", table.rows.back()[0], table.rows.back()[1], table.rows.back()[2]),
         .value = change.number(),
         .group = !improves        ? "worse"
                  : broken.empty() ? "better"
                                   : "better, but breaks a limit"});
  }
  if (!chart.bars.empty()) section.blocks.emplace_back(figure_of(chart));
  if (table.rows.empty())
    section.blocks.emplace_back(Paragraph{
        "No steps were looked at: the run was interrupted or its answer only was asked for, or nothing can vary."});
  else
    section.blocks.emplace_back(TableBlock{.caption = "Steps of the variables", .table = std::move(table)});
  Table relaxed{.header = {"limit", "relaxed to", "gain at least", "by the design"}};
  for (const Node& each : member_of(result, "binding").elements()) {
    const auto design = each.find("relaxed_best");
    relaxed.rows.push_back({cell_of(each, "constraint"), cell_of(each, "relaxed_to"), cell_of(each, "objective_change"),
                            design && !design->is_null() ? members_text(*design) : "-"});
  }
  if (!relaxed.rows.empty())
    section.blocks.emplace_back(TableBlock{.caption = "Limits in the way, each relaxed by 5 %", .table = relaxed});
  return section;
}

Section assumptions_section(const Node& result) {
  Section section{.id = "assumptions", .title = "What the answer rests on"};
  const std::vector<Node> all = member_of(result, "assumptions").elements();
  if (all.empty()) {
    section.blocks.emplace_back(Paragraph{fmt::format("Nothing else was looked at: {}.", why_left_out(result))});
    return section;
  }
  BarChart chart{
      .id = "choices",
      .title = "This design if something is otherwise",
      .description =
          "Value of the objective if a choice of the model or a number is otherwise, and whether the design then "
          "still keeps its limits.",
      .value_title = objective_of(result).name,
      .label_title = "if it is otherwise",
      .symbols = true};
  const double value = only_member_of(member_of(member_of(result, "best"), "objectives")).number();
  chart.bars.push_back({.label = "as taken", .value = value, .group = "as taken"});
  Table table{.header = {"subject", "taken", "otherwise", "objective then", "worst margin, % of its limit",
                         "another design", "settled by"}};
  std::vector<std::string> small;
  for (const Node& each : all) {
    if (const auto matters = each.find("matters"); matters && !matters->boolean()) {
      if (const std::string subject = cell_of(each, "subject"); small.empty() || small.back() != subject)
        small.push_back(subject);
      continue;
    }
    const std::vector<Node> objectives =
        member_of(each, "objectives").is_null() ? std::vector<Node>{} : member_of(each, "objectives").members();
    const auto worst = each.find("worst_margin");
    const auto other = each.find("other_best");
    const bool not_searched = result.find("as_built") && other && other->is_null();  // as of a study with a spread
    const bool known = !objectives.empty() && !objectives.front().is_null();
    table.rows.push_back(
        {cell_of(each, "subject"), cell_of(each, "taken"), cell_of(each, "otherwise"),
         known ? cell_of(objectives.front()) : "-",
         worst && !worst->is_null() ? fmt::format("{} ({:.3g})", cell_of(*worst, "limit"),
                                                  100.0 * member_of(*worst, "relative_margin").number())
                                    : "-",
         not_searched ? "not searched" : cell_of(each, "changes_design"), cell_of(each, "settled_by")});
    if (known)
      chart.bars.push_back({.label = fmt::format("{}: {}", table.rows.back()[0], table.rows.back()[2]),
                            .value = objectives.front().number(),
                            .group = member_of(each, "feasible").boolean() ? "keeps every limit" : "breaks a limit"});
  }
  section.blocks.emplace_back(figure_of(chart));
  section.blocks.emplace_back(TableBlock{.caption = "Choices and numbers that matter", .table = std::move(table)});
  if (!small.empty())
    section.blocks.emplace_back(Paragraph{fmt::format("Of less effect: {}.", fmt::join(small, ", "))});
  return section;
}

}  // namespace coilwright::page
