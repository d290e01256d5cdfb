#include "coilwright/page/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <variant>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/page/chart.hpp"
#include "coilwright/page/design_figures.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

using simulation::ChoiceEffect;
using simulation::DesignView;
using simulation::EvaluatedDesign;
using simulation::main_figures;
using simulation::PartLimit;

std::string value_text(const DesignView& design, std::string_view name) {
  const std::optional<double> value = simulation::standard_quantities().at(name).value(design);
  return value ? short_number(*value) : "-";
}

std::string value_text(const PartLimit& limit) {
  return limit.value ? short_number(*limit.value) : "no steady value";
}

std::vector<std::string> cautions_of(const std::vector<PartLimit>& limits) {
  std::vector<std::string> broken;
  std::vector<std::string> conditional;
  for (const PartLimit& each : limits)
    if (each.is_broken())
      (each.conditional ? conditional : broken)
          .push_back(fmt::format("{} is {}, beyond {}: {}", each.quantity, value_text(each), short_number(each.limit),
                                 each.consequence));
  std::vector<std::string> out;
  if (!broken.empty())
    out.push_back(fmt::format("BEWARE: the parts do not stand that for long: {}.", fmt::join(broken, "; ")));
  if (broken.empty() && !conditional.empty())
    out.push_back(
        fmt::format("MIND: the parts stand that on a condition, or with a loss: {}.", fmt::join(conditional, "; ")));
  return out;
}

std::string verdict_of(const DesignView& design, const std::vector<PartLimit>& limits) {
  std::vector<std::string> figures;
  for (const std::string_view name : main_figures)
    figures.push_back(fmt::format("{} {}", name, value_text(design, name)));
  const std::string does =
      fmt::format("With {} A {} and a duty of {}: {}.", short_number(design.point.current),
                  has_one_current(design.design)
                      ? "in every coil"
                      : fmt::format("of which the coils carry {}", fmt::join(current_shares(design.design), " and ")),
                  short_number(design.point.duty), fmt::join(figures, ", "));
  return cautions_of(limits).empty() ? does + " No part is beyond a limit of its own." : does;
}

Section limits_section(const std::vector<PartLimit>& limits) {
  Section section{.id = "limits", .title = "What the parts stand"};
  BarChart chart{.id = "margins",
                 .title = "Margins of the parts",
                 .description =
                     "How far each part is from its limit, in per cent of the limit. A bar to the left is a limit that "
                     "is broken; it ends at -100 % where there is no steady value.",
                 .value_title = "margin, %",
                 .label_title = "limit"};
  Table table{.header = {"quantity", "value", "limit", "beyond it"}};
  for (const PartLimit& each : limits) {
    const std::string limit = fmt::format("{} {}", each.at_most ? "<=" : ">=", short_number(each.limit));
    table.rows.push_back({std::string(each.quantity), value_text(each), limit, std::string(each.consequence)});
    chart.bars.push_back({.label = fmt::format("{} {}", each.quantity, limit),
                          .value = 100.0 * each.margin(),
                          .group = !each.is_broken()  ? "kept"
                                   : each.conditional ? "on a condition"
                                                      : "broken"});
  }
  section.blocks.emplace_back(figure_of(chart));
  section.blocks.emplace_back(TableBlock{.caption = "Limits of the parts", .table = std::move(table)});
  return section;
}

Section choices_section(const DesignView& design, std::span<const ChoiceEffect> effects) {
  Section section{.id = "assumptions", .title = "What the answer rests on"};
  Table table{.header = {"subject", "taken", "otherwise"}};
  for (const std::string_view name : main_figures) table.header.emplace_back(name);
  table.header.emplace_back("settled by");
  std::vector<std::string> taken{"as taken", "", ""};
  for (const std::string_view name : main_figures) taken.push_back(value_text(design, name));
  taken.emplace_back("");
  table.rows.push_back(std::move(taken));
  for (const ChoiceEffect& each : effects) {
    if (!each.matters()) continue;
    std::vector<std::string> row{std::string(each.choice.subject), each.choice.taken, each.choice.otherwise};
    const auto* other = std::get_if<EvaluatedDesign>(&each.result);
    for (const std::string_view name : main_figures)
      row.push_back(other != nullptr ? value_text(other->view(), name) : "-");
    row.emplace_back(each.choice.settled_by);
    table.rows.push_back(std::move(row));
  }
  section.blocks.emplace_back(TableBlock{
      .caption = "The same parts where a choice or a number that matters is otherwise", .table = std::move(table)});
  return section;
}

Section quantities_section(const DesignView& design) {
  Section section{.id = "quantities", .title = "All quantities"};
  Table table{.header = {"quantity", "value", "meaning"}};
  for (const simulation::ResultQuantity& each : simulation::standard_quantities())
    table.rows.push_back({each.name, value_text(design, each.name), each.meaning});
  section.blocks.emplace_back(TableBlock{.caption = "Quantities of this design", .table = std::move(table)});
  return section;
}

}  // namespace

Page evaluation_page(const EvaluatedDesign& evaluated, std::span<const ChoiceEffect> effects, std::string_view name,
                     std::string_view made_by) {
  const DesignView design = evaluated.view();
  const std::vector<PartLimit> limits = told(simulation::part_limits(design), design);
  Page page{.title = fmt::format("{} at {} A", name, short_number(design.point.current)),
            .verdict = verdict_of(design, limits),
            .cautions = cautions_of(limits),
            .origin = fmt::format("Page by {}.", made_by),
            .sections = design_sections(evaluated, {.name = std::string(name), .made_by = std::string(made_by)})};
  page.sections.push_back(limits_section(limits));
  page.sections.push_back(choices_section(design, effects));
  page.sections.push_back(quantities_section(design));
  return page;
}

}  // namespace coilwright::page
