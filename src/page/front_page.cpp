#include "page/result_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/markup.hpp"
#include "page/front.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

using text::Json;
using text::Node;

constexpr std::size_t most_with_quantities = 5000;

// front.csv, column by column, for the tables of the selection.
Json columns_json(const FrontTable& front) {
  // With very many designs the quantities beside objectives and margins are left to front.csv.
  const std::vector<std::string> quantities =
      front.rows() > most_with_quantities ? std::vector<std::string>{} : front.quantities;
  Json columns = Json::object();
  for (const std::string& name : front.texts.names()) {
    const bool other = std::ranges::find(front.quantities, name) != front.quantities.end();
    if (other && quantities.empty()) continue;
    Json column = Json::array();
    for (const std::string& field : front.texts.column(name)) column.add(json_of(field));
    columns.set(name, std::move(column));
  }
  return Json::object({{"variables", texts_json(front.variables)},
                       {"objectives", texts_json(front.objectives)},
                       {"margins", texts_json(front.margins)},
                       {"quantities", texts_json(quantities)},
                       {"columns", std::move(columns)}});
}

// What selects a design; the script fills in the rest. A slider is reached and moved by the keyboard of itself.
std::string controls_html(const FrontTable& front) {
  return fmt::format(
      "<div class=\"controls\" role=\"group\" aria-label=\"Selection of a design\">\n"
      "<label for=\"pick\">Design <output id=\"pick-text\" for=\"pick\">1</output> of {0}, in the order of "
      "{1}</label>\n"
      "<input type=\"range\" id=\"pick\" min=\"1\" max=\"{0}\" value=\"1\" step=\"1\">\n"
      "<div id=\"landmarks\"></div>\n"
      "<button type=\"button\" id=\"save\">Save this design as an actuator file</button>\n</div>\n",
      front.rows(), text::escaped(front.objectives.front()));
}

constexpr const char* selection_html =
    "<p id=\"selection-text\" role=\"status\" aria-live=\"polite\"></p>\n"
    "<div id=\"selection-poses\" class=\"poses\"></div>\n"
    "<figure id=\"selection-response\"><h3>Bending angle after a step of the current</h3>\n"
    "<div class=\"plot\" id=\"selection-response-plot\" role=\"img\"></div>\n"
    "<figcaption id=\"selection-response-text\"></figcaption></figure>\n"
    "<div class=\"columns\"><div class=\"wide\" id=\"selection-variables\"></div><div class=\"wide\" "
    "id=\"selection-margins\"></div></div>\n"
    "<details><summary>All quantities of this design</summary><div class=\"wide\" "
    "id=\"selection-quantities\"></div></details>\n";

constexpr std::size_t most_design_rows = 500;

TableBlock front_rows(const FrontTable& front) {
  Table table{.header = {"design"}};
  const std::vector<std::string> shown = shown_columns(front);
  table.header.insert(table.header.end(), shown.begin(), shown.end());
  const std::vector<std::size_t> rows = even_choice(front.rows(), most_design_rows);
  for (const std::size_t row : rows) {
    std::vector<std::string> cells{std::to_string(row + 1)};
    for (std::string& field : shown_fields(front, row, shown)) cells.push_back(std::move(field));
    table.rows.push_back(std::move(cells));
  }
  const std::string some =
      rows.size() == front.rows()
          ? "Designs of the front"
          : fmt::format("Designs of the front: {} of {}, evenly; front.csv has all", rows.size(), front.rows());
  return {.caption = some, .table = std::move(table)};
}

std::string table_details(const FrontTable& front) {
  // Behind a summary, as every table of a plot.
  return fmt::format(
      "<details id=\"front-table\"><summary>The designs of the front as a table</summary>\n{}</details>\n",
      report::to_html(front_rows(front)));
}

void add_convergence(Page& page, const std::filesystem::path& folder) {
  const text::CsvTexts table = read_table(folder / "convergence.csv");
  Series series{.name = "hypervolume", .mark = Mark::steps};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto x = table.number("evaluation", row);
    const auto y = table.number("hypervolume", row);
    if (!x || !y) continue;
    series.x.push_back(*x);
    series.y.push_back(*y);
  }
  if (series.x.empty()) return;
  section_named(page, "convergence")
      .blocks.emplace_back(figure_of(
          Chart{.id = "search",
                .title = "How full the front was after so many evaluations",
                .description = "Hypervolume of the front so far in the frame of the final one: ideal 0, nadir "
                               "1, reference 1.1. It says how full the front is, not how far it reaches.",
                .x_title = "evaluation",
                .y_title = "hypervolume",
                .series = {std::move(series)}}));
}

// Why there are no pictures, or why not all.
std::string pictures_text(const FrontTable& front, const PageInputs& inputs) {
  if (!inputs.study) return fmt::format("Sections, motion and actuator files are missing: {}", inputs.why_no_study);
  if (front.rows() <= inputs.most_pictures) return {};
  return fmt::format(
      "{} of the {} designs, evenly along the front, are drawn and simulated (report --pictures N draws more); the "
      "tables and the actuator file are there for all.",
      inputs.most_pictures, front.rows());
}

Json landmarks_of(const Node& result, const FrontTable& front) {
  Json out = Json::array();
  const auto row_of = [&](const Node& design) {
    for (std::size_t row = 0; row < front.rows(); ++row) {
      bool same = true;
      for (const Node& variable : member_of(design, "variables").members()) {
        const std::string& field = front.texts.column(variable.key()).at(row);
        same = same && (variable.kind() == Node::Kind::number ? text::number_in(field) == variable.number()
                                                              : field == cell_of(variable));
      }
      if (same) return row;
    }
    throw front.texts.error(fmt::format("must have the design of {} in {} beside it", design.pointer(), "result.json"));
  };
  const std::vector<Node> ends = member_of(result, "ends").elements();
  for (std::size_t i = 0; i < ends.size() && i < front.objectives.size(); ++i)
    out.add(Json::object({{"name", "best " + front.objectives[i]}, {"row", row_of(ends[i])}}));
  const auto middle = result.find("middle");
  if (middle && !middle->is_null()) out.add(Json::object({{"name", "middle of the front"}, {"row", row_of(*middle)}}));
  return out;
}

}  // namespace

Page front_page(const std::filesystem::path& folder, const Node& result, const PageInputs& inputs) {
  const FrontTable front = read_front(folder, result);
  require_rows(front.texts, member_of(result, "front_size").integer<std::uint32_t>());
  Page page = page_of(folder, result, inputs.made_by);
  const OtherDesigns others = read_other_designs(folder, result, front);
  std::vector<Section> sections;
  Section& trade = sections.emplace_back(Section{.id = "trade", .title = "The trade-off"});
  if (front.rows() > 0) trade.blocks.emplace_back(Widget{controls_html(front)});
  for (Figure& figure : front_figures(front, others)) trade.blocks.emplace_back(std::move(figure));
  if (front.rows() > 0) {
    trade.blocks.emplace_back(Widget{table_details(front)});
    Section& selection = sections.emplace_back(Section{.id = "selection", .title = "The selected design"});
    if (front.rows() > most_with_quantities)
      selection.blocks.emplace_back(Lines{fmt::format(
          "Of {} designs the page has objectives, variables and margins; every other quantity is in front.csv.",
          front.rows())});
    if (std::string missing = pictures_text(front, inputs); !missing.empty())
      selection.blocks.emplace_back(Lines{std::move(missing)});
    selection.blocks.emplace_back(Widget{selection_html});
    add_convergence(page, folder);
  }
  page.sections.insert(page.sections.begin(), std::make_move_iterator(sections.begin()),
                       std::make_move_iterator(sections.end()));
  if (front.rows() == 0) return page;
  page.data.push_back({.id = "front-data", .json = columns_json(front).text()});
  page.data.push_back({.id = "front-landmarks", .json = landmarks_of(result, front).text()});
  if (inputs.study) {
    page.data.push_back(
        {.id = "front-pictures", .json = front_pictures(*inputs.study, front, inputs.most_pictures).text()});
    page.data.push_back({.id = "front-actuators", .json = front_actuators(*inputs.study, front).text()});
  }
  return page;
}

}  // namespace coilwright::page
