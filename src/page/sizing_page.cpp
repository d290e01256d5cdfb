#include "page/result_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/page/chart.hpp"
#include "coilwright/page/design_figures.hpp"
#include "coilwright/report/size_text.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

using text::Node;

// Why the search itself ended; of results that do not say so, why the run did.
std::string search_stop_reason(const Node& result) {
  const auto reason = result.find("search_stop_reason");
  return reason ? reason->text() : cell_of(result, "stop_reason");
}

// Of an interrupted run, of what the design found breaks of its parts, and of limits that
// too few builds keep.
std::vector<std::string> cautions_of_design(const Node& result, const std::optional<sizing::Yield>& built) {
  const auto limits = result.find("part_limits");
  std::vector<std::string> broken;
  std::vector<std::string> conditional;
  for (const Node& each : limits ? limits->elements() : std::vector<Node>()) {
    if (!member_of(each, "broken").boolean()) continue;
    const char* side = each.find("at_most") ? "at_most" : "at_least";
    (is_conditional(each) ? conditional : broken)
        .push_back(fmt::format("{} {}, {} {}: {}", cell_of(each, "quantity"), cell_of(each, "value"),
                               each.find("at_most") ? "at most" : "at least", cell_of(each, side),
                               cell_of(each, "consequence")));
  }
  std::vector<std::string> out;
  if (was_interrupted(result))
    out.emplace_back(search_stop_reason(result) == "interrupted" ? interrupted_caution
                                                                 : report::interrupted_after_search);
  if (!is_feasible(result)) return out;
  if (!broken.empty())
    out.push_back(fmt::format("BEWARE: it breaks limits of its parts ({}).", fmt::join(broken, "; ")));
  if (broken.empty() && !conditional.empty()) out.push_back(fmt::format("MIND: {}.", fmt::join(conditional, "; ")));
  if (built)
    if (std::string shortfalls = report::shortfalls_of_answer_text(*built); !shortfalls.empty())
      out.push_back(std::move(shortfalls));
  return out;
}

std::string verdict_of(const Node& result) {
  const Objective objective = objective_of(result);
  const Node best = member_of(result, "best");
  if (best.is_null()) return "No design was evaluated.";
  if (!is_feasible(result)) {
    std::vector<std::string> broken;
    for (const Node& each : member_of(result, "violated").elements()) broken.push_back(cell_of(each));
    return fmt::format(
        "No design that was found keeps every limit; this page shows the least infeasible one, which breaks {}.",
        fmt::join(broken, ", "));
  }
  const double value = only_member_of(member_of(best, "objectives")).number();
  const std::vector<Node> limits = member_of(best, "constraints").elements();
  std::string out = fmt::format("The {} {} found is {}", objective.largest ? "largest" : "smallest", objective.name,
                                short_number(value));
  if (limits.empty()) {
    out += ", without any limit";
  } else {
    const auto tightest = std::ranges::min_element(limits, {}, [](const Node& each) { return margin_percent(each); });
    out += fmt::format(", with {} kept and {} the tightest ({:.2g} % left)",
                       limits.size() == 1 ? "its limit" : fmt::format("all {} limits", limits.size()),
                       limit_text(*tightest), margin_percent(*tightest));
  }
  std::size_t changes = 0;
  std::vector<Node> assumptions = member_of(result, "assumptions").elements();
  std::erase_if(assumptions, [](const Node& each) {
    const auto number = each.find("number");
    return number && !number->is_null();  // for which no other design is looked
  });
  for (const Node& each : assumptions) changes += member_of(each, "changes_design").boolean() ? 1 : 0;
  if (changes > 0)
    out += fmt::format("; {} of {} other modelling choices would lead to another design", changes, assumptions.size());
  const auto first = result.find("measure_first");
  if (first && !first->is_null()) out += fmt::format(". Measure first: {}", first->text());
  return out + ".";
}

TableBlock variables_table(const Node& result) {
  Table table{.header = {"variable", "value"}};
  for (const Node& each : member_of(member_of(result, "best"), "variables").members())
    table.rows.push_back({each.key(), cell_of(each)});
  const auto ends = result.find("at_range_end");
  if (ends && !ends->elements().empty()) {
    table.header.emplace_back("at an end of its range");
    for (std::vector<std::string>& row : table.rows) {
      std::string end;
      for (const Node& each : ends->elements())
        if (member_of(each, "variable").text() == row.front()) end = member_of(each, "end").text();
      row.push_back(end);
    }
  }
  return {.caption = "Variables of the design", .table = std::move(table)};
}

Section limits_section(const Node& result) {
  Section section{.id = "limits", .title = "Objective and limits"};
  const Node best = member_of(result, "best");
  std::string line = fmt::format("{}.", only_member_text(member_of(best, "objectives")));
  const auto base = result.find("base");
  if (base && base->find("objectives"))
    line += fmt::format(" The study's own actuator with {} A, for comparison: {}.", cell_of(*base, "current_A"),
                        only_member_text(member_of(*base, "objectives")));
  else if (base && base->find("reason"))
    line += fmt::format(" The study's own actuator, for comparison, has none: {}.", cell_of(*base, "reason"));
  section.blocks.emplace_back(Paragraph{line});
  Table table{.header = {"limit", "value", "margin", "margin, % of the limit", "in the way"}};
  BarChart chart{.id = "margins",
                 .title = "Margins",
                 .description =
                     "How far each limit is from being reached, in per cent of the limit (of an ordinary magnitude "
                     "where the limit is 0). A bar to the left is a limit that is broken.",
                 .value_title = "margin, %",
                 .label_title = "limit"};
  for (const Node& each : member_of(best, "constraints").elements()) {
    const double percent = margin_percent(each);
    std::string way;
    for (const Node& binding : member_of(result, "binding").elements())
      if (member_of(binding, "constraint").text() == limit_text(each))
        way = member_of(binding, "at_limit").boolean() ? "at its limit" : "an improving step breaks it";
    table.rows.push_back(
        {limit_text(each), cell_of(each, "value"), cell_of(each, "margin"), fmt::format("{:.3g}", percent), way});
    chart.bars.push_back({.label = limit_text(each),
                          .value = percent,
                          .group = percent < 0.0 ? "broken"
                                   : way.empty() ? "kept, not in the way"
                                                 : "kept, in the way"});
  }
  if (chart.bars.empty()) {
    section.blocks.emplace_back(Paragraph{"The study has no limits."});
    return section;
  }
  section.blocks.emplace_back(figure_of(chart));
  section.blocks.emplace_back(TableBlock{.caption = "Limits", .table = std::move(table)});
  return section;
}

Section convergence_section(const std::filesystem::path& folder, const Node& result) {
  Section section{.id = "convergence", .title = "Convergence"};
  const std::string objective = objective_of(result).name;
  const text::CsvTexts best = read_table(folder / "convergence.csv");
  const text::CsvTexts all = text::read_csv_texts(folder / "evaluations.csv", [&](std::string_view name) {
    return name == "evaluation" || name == "status" || name == objective;
  });
  require_rows(all, evaluations_of(result));
  Chart chart{.id = "search",
              .title = "Every design of the search",
              .description = fmt::format(
                  "The best {} so far, and the value of every design that was evaluated, {} of them.{}", objective,
                  cell_of(member_of(result, "evaluations"), "total"), end_of_search(result, false)),
              .x_title = "evaluation",
              .y_title = objective};
  for (const auto& [status, name] : {std::pair{"infeasible", "breaks a limit"}, std::pair{"ok", "keeps every limit"}}) {
    Series series{.name = name, .mark = Mark::faint};
    for (std::size_t row = 0; all.has(objective) && row < all.rows(); ++row) {
      const auto place = all.number("evaluation", row);
      const auto value = all.number(objective, row);
      if (all.column("status")[row] != status || !place || !value) continue;
      series.x.push_back(*place);
      series.y.push_back(*value);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  Series so_far{.name = "best so far", .mark = Mark::steps};
  for (std::size_t row = 0; row < best.rows(); ++row) {
    const auto value = best.number("best_" + objective, row);
    if (!value) continue;
    so_far.x.push_back(best.required_number("evaluation", row));
    so_far.y.push_back(*value);
  }
  if (!so_far.x.empty()) chart.series.push_back(std::move(so_far));
  if (chart.series.empty())
    section.blocks.emplace_back(Paragraph{"No design of the search has a value of the objective."});
  else
    section.blocks.emplace_back(figure_of(chart));
  return section;
}

// Design sections of actuator.json, evaluated anew at the operating point that it carries.
std::vector<Section> sections_of_actuator(const std::filesystem::path& file, std::string_view made_by) {
  const formats::ActuatorFile actuator = formats::read_actuator(file);
  const auto* design = std::get_if<actuator::Design>(&actuator.content);
  if (design == nullptr || !actuator.operating_point) return {};
  try {
    return design_sections(simulation::evaluate(*design, *actuator.operating_point),
                           {.name = actuator.name, .made_by = std::string(made_by)});
  } catch (const std::runtime_error& why) {
    return {{.id = "design",
             .title = "The design",
             .blocks = {Paragraph{fmt::format("It cannot be evaluated: {}.", why.what())}}}};
  }
}

Section quantities_section(const Node& result) {
  Section section{.id = "quantities", .title = "All quantities"};
  const auto performance = result.find("performance");
  if (!performance || performance->is_null()) return section;
  Table table{.header = {"quantity", "value", "meaning"}};
  for (const Node& each : performance->members()) {
    const auto* quantity = simulation::standard_quantities().find(each.key());
    if (each.kind() != Node::Kind::number && !each.is_null()) continue;
    table.rows.push_back({each.key(), cell_of(each), quantity == nullptr ? "" : quantity->meaning});
  }
  section.blocks.emplace_back(TableBlock{.caption = "Quantities of this design", .table = std::move(table)});
  return section;
}

}  // namespace

Page sizing_page(const std::filesystem::path& folder, const Node& result, std::string_view made_by) {
  const auto builds = result.find("as_built");  // null where they were left out
  const std::optional<sizing::Yield> built =
      builds && !builds->is_null() ? std::optional(formats::read_yield(*builds)) : std::nullopt;
  // Nothing is made of it here, as actuator.json has it too; a result with something else in its place is none.
  if (const auto point = result.find("operating_point"); point && !point->is_null())
    (void)formats::read_operating_point(*point);
  Page page{.title = fmt::format("{}: sizing", member_of(result, "study").text()),
            .verdict = verdict_of(result),
            .cautions = cautions_of_design(result, built),
            .origin = origin_text(folder, made_by),
            .inputs = input_lines(folder)};
  const Node best = member_of(result, "best");
  if (best.is_null()) return page;
  std::vector<Section> design;
  if (std::filesystem::is_regular_file(folder / "actuator.json"))
    design = sections_of_actuator(folder / "actuator.json", made_by);
  if (design.empty()) design.push_back({.id = "design", .title = "The design"});
  design.front().blocks.insert(design.front().blocks.begin(), variables_table(result));
  page.sections.push_back(std::move(design.front()));
  page.sections.push_back(limits_section(result));
  for (std::size_t i = 1; i < design.size(); ++i) page.sections.push_back(std::move(design[i]));
  if (builds) page.sections.push_back(builds_section(result, built));
  page.sections.push_back(sensitivity_section(result));
  page.sections.push_back(assumptions_section(result));
  page.sections.push_back(convergence_section(folder, result));
  page.sections.push_back(quantities_section(result));
  return page;
}

}  // namespace coilwright::page
