#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/page/chart.hpp"
#include "coilwright/page/design_figures.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/result_pages.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

using text::Node;

Block convergence_block(const std::filesystem::path& folder, const Node& result) {
  const std::string objective = objective_of(result).name;
  const text::CsvTexts best = read_table(folder / "convergence.csv");
  const text::CsvTexts all = text::read_csv_texts(folder / "evaluations.csv", [&](std::string_view name) {
    return name == "evaluation" || name == "status" || name == objective;
  });
  require_rows(all, evaluations_of(result));
  Chart chart{
      .id = "search",
      .title = "Every design of the search",
      .description = fmt::format("The best {} so far, and the value of every design that was evaluated, {} of them.",
                                 objective, cell_of(member_of(result, "evaluations"), "total")),
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
  if (chart.series.empty()) return Lines{"No design of the search has a value of the objective."};
  return figure_of(chart);
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
             .blocks = {Lines{fmt::format("It cannot be evaluated: {}.", why.what())}}}};
  }
}

// The sections that draw a design stand behind the one that names it, whose title the first of them takes.
void add_drawings(Page& page, std::vector<Section> drawings) {
  const auto design = std::ranges::find(page.sections, "design", &Section::id);
  if (drawings.empty() || design == page.sections.end()) return;
  std::ranges::move(drawings.front().blocks, std::back_inserter(design->blocks));
  page.sections.insert(design + 1, std::make_move_iterator(drawings.begin() + 1),
                       std::make_move_iterator(drawings.end()));
}

}  // namespace

Page evaluation_page(const simulation::EvaluatedDesign& evaluated, const report::Document& document,
                     std::string_view name, std::string_view made_by) {
  Page page = page_of(document, fmt::format("Page by {}.", made_by));
  page.title = fmt::format("{} at {} A", name, short_number(evaluated.point.current));
  std::vector<Section> drawings =
      design_sections(evaluated, {.name = std::string(name), .made_by = std::string(made_by)});
  page.sections.insert(page.sections.begin(), std::make_move_iterator(drawings.begin()),
                       std::make_move_iterator(drawings.end()));
  return page;
}

Page sizing_page(const std::filesystem::path& folder, const Node& result, std::string_view made_by) {
  Page page = page_of(folder, result, made_by);
  if (member_of(result, "best").is_null()) return page;
  if (std::filesystem::is_regular_file(folder / "actuator.json"))
    add_drawings(page, sections_of_actuator(folder / "actuator.json", made_by));
  section_named(page, "convergence").blocks.push_back(convergence_block(folder, result));
  return page;
}

}  // namespace coilwright::page
