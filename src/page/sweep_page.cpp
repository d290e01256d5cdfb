#include "page/result_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/page/design_figures.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/front.hpp"
#include "page/result_words.hpp"
#include "page/sweep_table.hpp"

namespace coilwright::page {
namespace {

using text::Node;

// The row of best.csv with the best value of an objective over all configurations; nothing where none keeps the limits.
std::optional<std::size_t> best_row(const FrontTable& leaders, std::size_t objective) {
  const std::string& name = leaders.objectives[objective];
  std::optional<std::size_t> best;
  for (std::size_t row = 0; row < leaders.rows(); ++row) {
    if (leaders.texts.column("best_for")[row] != name || leaders.texts.column("status")[row] != "ok") continue;
    const double value = leaders.texts.required_number(name, row);
    if (best) {
      const double so_far = leaders.texts.required_number(name, *best);
      if (leaders.largest[objective] ? value <= so_far : value >= so_far) continue;
    }
    best = row;
  }
  return best;
}

std::string variables_text(const FrontTable& leaders, std::size_t row) {
  std::vector<std::string> parts;
  for (const std::string& name : leaders.variables) {
    const std::string& field = leaders.texts.column(name)[row];
    const std::optional<double> number = text::number_in(field);
    parts.push_back(fmt::format("{} {}", name, number ? short_number(*number) : field));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string series_name(const SweepTable::Best& best) {
  return best.group.empty() ? "best of all others" : fmt::format("best with configuration {}", best.group);
}

// Numbers in their order, with their values of one objective.
std::optional<Series> best_series(const SweepTable::Best& best, std::size_t objective) {
  std::vector<std::pair<double, double>> points;
  for (const auto& [field, values] : best.rows) {
    const std::optional<double> x = text::number_in(field);
    if (!x) return std::nullopt;
    points.emplace_back(*x, values[objective]);
  }
  std::ranges::sort(points);
  Series out{.name = series_name(best), .mark = Mark::line};
  for (const auto& [x, y] : points) {
    out.x.push_back(x);
    out.y.push_back(y);
  }
  return out;
}

Series samples_series(const SweepTable& table, std::size_t variable, std::size_t objective, bool keeps_limits) {
  Series out{.name = keeps_limits ? "keeps every limit" : "breaks a limit", .mark = Mark::faint};
  for (const SweepTable::Sample& each : table.samples) {
    if (each.keeps_limits != keeps_limits || !each.objectives[objective]) continue;
    const std::optional<double> x = text::number_in(each.variables[variable]);
    if (!x) continue;
    out.x.push_back(*x);
    out.y.push_back(*each.objectives[objective]);
  }
  return out;
}

// What a variable whose values are words does: a bar a value.
Figure words_figure(const SweepTable& table, const FrontTable& leaders, std::size_t variable, std::size_t objective,
                    std::string id) {
  BarChart chart{.id = std::move(id),
                 .title = fmt::format("{} by {}", leaders.objectives[objective], table.variables[variable]),
                 .description = fmt::format("The best {} that keeps every limit, for each value of {}.",
                                            leaders.objectives[objective], table.variables[variable]),
                 .value_title = leaders.objectives[objective],
                 .label_title = table.variables[variable],
                 .symbols = true};
  for (const SweepTable::Best& group : table.best[variable])
    for (const auto& [field, values] : group.rows)
      chart.bars.push_back({.label = field, .value = values[objective], .group = series_name(group)});
  return figure_of(chart);
}

std::string behind_text(const SweepTable& table) {
  if (table.samples.size() == table.rows) return "every design";
  return fmt::format("{} of the {} designs: those that have a value, or of very many a random choice",
                     table.samples.size(), table.rows);
}

std::optional<Figure> effect_figure(const SweepTable& table, const FrontTable& leaders, std::size_t variable,
                                    std::size_t objective) {
  const std::string& name = table.variables[variable];
  const std::string& wanted = leaders.objectives[objective];
  std::string id = fmt::format("effect-{}-{}", objective + 1, variable + 1);
  // Each design of a sample has values of its own: a line through them says nothing.
  const std::string lines =
      table.sampled
          ? ""
          : fmt::format(
                "Lines: the best {} that keeps every limit at each value of {}, whatever the other variables are. ",
                wanted, name);
  Chart chart{.id = id,
              .title = fmt::format("{} over {}", wanted, name),
              .description = fmt::format("{}{} is better. Points: {}.", lines,
                                         leaders.largest[objective] ? "More" : "Less", behind_text(table)),
              .x_title = name,
              .y_title = wanted};
  for (const bool keeps : {false, true}) {
    Series samples = samples_series(table, variable, objective, keeps);
    if (!samples.x.empty()) chart.series.push_back(std::move(samples));
  }
  if (chart.series.empty() && table.best[variable].empty()) return std::nullopt;
  if (chart.series.empty()) return words_figure(table, leaders, variable, objective, std::move(id));
  for (const SweepTable::Best& group : table.best[variable]) {
    std::optional<Series> line = best_series(group, objective);
    if (!line) return words_figure(table, leaders, variable, objective, std::move(id));
    if (!table.sampled) chart.series.push_back(*std::move(line));
  }
  return figure_of(chart);
}

std::vector<Section> effect_sections(const SweepTable& table, const FrontTable& leaders) {
  std::vector<Section> sections;
  for (std::size_t objective = 0; objective < leaders.objectives.size(); ++objective) {
    Section section{.id = fmt::format("effects-{}", objective + 1),
                    .title = fmt::format("What each variable does to {}", leaders.objectives[objective])};
    for (std::size_t variable = 0; variable < table.variables.size(); ++variable)
      if (std::optional<Figure> figure = effect_figure(table, leaders, variable, objective))
        section.blocks.emplace_back(*std::move(figure));
    if (section.blocks.empty()) section.blocks.emplace_back(Lines{"No design has a value of it."});
    sections.push_back(std::move(section));
  }
  return sections;
}

Section limits_section(const SweepTable& table) {
  Section section{.id = "limits", .title = "Which limits decide"};
  if (table.broken.empty()) section.blocks.emplace_back(Lines{"The study has no limits."});
  Table rows{.header = {"margin below zero", "designs", "of those: the only limit broken"}};
  for (const SweepTable::Broken& each : table.broken)
    rows.rows.push_back({each.margin, std::to_string(each.times), std::to_string(each.alone)});
  if (!rows.rows.empty())
    section.blocks.emplace_back(TableBlock{
        .caption = fmt::format("How many of the {} designs break each limit", table.rows), .table = std::move(rows)});
  Table failed{.header = {"why a design could not be evaluated", "designs"}};
  for (const auto& [reason, times] : table.failures) failed.rows.push_back({reason, std::to_string(times)});
  if (!failed.rows.empty())
    section.blocks.emplace_back(
        TableBlock{.caption = "Designs that could not be evaluated", .table = std::move(failed)});
  return section;
}

// The best design of the first objective, drawn and simulated.
std::vector<Section> drawn_sections(const FrontTable& leaders, const PageInputs& inputs) {
  const std::optional<std::size_t> row = best_row(leaders, 0);
  if (!row) return {};
  Section head{.id = "design", .title = fmt::format("The best design for {}", leaders.objectives[0])};
  if (!inputs.study) {
    head.blocks.emplace_back(Lines{fmt::format("It cannot be drawn: {}", inputs.why_no_study)});
    return {std::move(head)};
  }
  const sizing::DesignProblem problem(*inputs.study);
  const std::optional<sizing::EvaluatedDesign> design = evaluated_row(problem, leaders, *row);
  if (!design) {
    head.blocks.emplace_back(
        Lines{"It cannot be drawn: evaluated by this program it comes out other than its row has it."});
    return {std::move(head)};
  }
  std::vector<Section> sections = design_sections(
      *design,
      {.name = fmt::format("{}, best {}", problem.study().name, leaders.objectives[0]), .made_by = inputs.made_by});
  sections.front().title = head.title;
  sections.front().blocks.insert(sections.front().blocks.begin(), Lines{variables_text(leaders, *row) + "."});
  return sections;
}

}  // namespace

Page sweep_page(const std::filesystem::path& folder, const Node& result, const PageInputs& inputs) {
  const FrontTable leaders = read_leaders(folder, result);
  Page page = page_of(folder, result, inputs.made_by);
  const auto evaluated = member_of(result, "evaluated").integer<std::size_t>();
  if (evaluated == 0) return page;
  const SweepTable table = read_sweep(folder, leaders, evaluated, result.find("sample").has_value());
  if (std::optional<Section> map = map_section(table, leaders)) page.sections.push_back(*std::move(map));
  for (Section& section : effect_sections(table, leaders)) page.sections.push_back(std::move(section));
  page.sections.push_back(limits_section(table));
  for (Section& section : drawn_sections(leaders, inputs)) page.sections.push_back(std::move(section));
  return page;
}

}  // namespace coilwright::page
