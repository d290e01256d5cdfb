#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/sweep_table.hpp"

namespace coilwright::page {
namespace {

using text::Json;

constexpr std::size_t most_cells_shown = 10000;
constexpr std::size_t most_map_rows = 400;

// What differs between the map of a grid and that of a sample. Names of variables and quantities begin with a letter:
// fields that begin with "_" are none of them.
struct MapParts {
  std::vector<std::string> pairs{};  // "gap_mm, turns_radial"
  Json rows = Json::array();
  Json transform = Json::array();
  std::string description{};
  Table table{};
};

std::string pair_text(const SweepTable& table, std::size_t across, std::size_t up) {
  return fmt::format("{}, {}", table.variables[across], table.variables[up]);
}

Json calculated(const char* expression, const char* field) {
  return Json::object({{"calculate", expression}, {"as", field}});
}

Json flattened(const std::vector<std::string>& fields) {
  return Json::object({{"flatten", texts_json(fields)}});
}

// The cells of one map, column by column.
Json cells_json(const SweepTable& table, const FrontTable& leaders, const SweepTable::Map& map) {
  Json x = Json::array();
  Json y = Json::array();
  for (const auto& [at, best] : map.cells) {
    x.add(json_of(table.values[map.across][at.first]));
    y.add(json_of(table.values[map.up][at.second]));
  }
  Json out =
      Json::object({{"_pair", pair_text(table, map.across, map.up)}, {"_x", std::move(x)}, {"_y", std::move(y)}});
  for (std::size_t i = 0; i < leaders.objectives.size(); ++i)
    out.set(leaders.objectives[i],
            Json::list(map.cells, [&](const auto& cell) { return cell.second.empty() ? Json() : cell.second[i]; }));
  return out;
}

Table cells_table(const SweepTable& table, const FrontTable& leaders, const SweepTable::Map& map) {
  Table out{.header = {table.variables[map.across], table.variables[map.up]}};
  out.header.insert(out.header.end(), leaders.objectives.begin(), leaders.objectives.end());
  const std::vector<std::size_t> rows = even_choice(map.cells.size(), most_map_rows);
  for (const std::size_t row : rows) {
    const auto& [at, best] = *std::next(map.cells.begin(), static_cast<std::ptrdiff_t>(row));
    out.rows.push_back({table.values[map.across][at.first], table.values[map.up][at.second]});
    for (std::size_t i = 0; i < leaders.objectives.size(); ++i)
      out.rows.back().push_back(best.empty() ? "-" : fmt::format("{:.6g}", best[i]));
  }
  if (rows.size() < map.cells.size()) out.note = fmt::format("of {}", map.cells.size());
  return out;
}

MapParts parts_of_grid(const SweepTable& table, const FrontTable& leaders) {
  MapParts out;
  std::size_t shown = 0;
  for (const SweepTable::Map& map : table.maps) {
    if (map.cells.empty() || shown + map.cells.size() > most_cells_shown) continue;
    if (out.pairs.empty()) out.table = cells_table(table, leaders, map);
    shown += map.cells.size();
    out.pairs.push_back(pair_text(table, map.across, map.up));
    out.rows.add(cells_json(table, leaders, map));
  }
  std::vector<std::string> fields{"_x", "_y"};
  fields.insert(fields.end(), leaders.objectives.begin(), leaders.objectives.end());
  out.transform = Json::array(
      {Json::object({{"filter", "datum._pair === pair"}}), flattened(fields), calculated("datum[quantity]", "_value")});
  out.description =
      "The best design that keeps every limit at each two values, whatever the other variables are; grey where none "
      "does.";
  if (out.pairs.size() < table.maps.size())
    out.description += fmt::format(
        " {} of {} pairs of variables are here: none of more than 2500 cells, and together at most {}; designs.csv has "
        "all.",
        out.pairs.size(), table.maps.size(), most_cells_shown);
  return out;
}

// Whether the samples have numbers of a variable, and more than one.
bool is_axis(const SweepTable& table, std::size_t variable) {
  std::set<std::optional<double>> values;
  for (const SweepTable::Sample& each : table.samples) values.insert(text::number_in(each.variables[variable]));
  return values.size() > 1 && !values.contains(std::nullopt);
}

MapParts parts_of_sample(const SweepTable& table, const FrontTable& leaders) {
  MapParts out;
  std::vector<std::size_t> axes;
  std::vector<std::string> fields;
  Json columns = Json::object();
  const auto add = [&](const std::string& name, Json values) {
    if (std::ranges::find(fields, name) != fields.end()) return;  // an objective that is a variable
    fields.push_back(name);
    columns.set(name, std::move(values));
  };
  for (std::size_t v = 0; v < table.variables.size(); ++v) {
    if (!is_axis(table, v)) continue;
    for (const std::size_t across : axes) out.pairs.push_back(pair_text(table, across, v));
    axes.push_back(v);
    add(table.variables[v],
        Json::list(table.samples, [v](const SweepTable::Sample& each) { return json_of(each.variables[v]); }));
  }
  for (std::size_t i = 0; i < leaders.objectives.size(); ++i)
    add(leaders.objectives[i],
        Json::list(table.samples, [i](const SweepTable::Sample& each) { return Json(each.objectives[i]); }));
  add("_keeps", Json::list(table.samples, [](const SweepTable::Sample& each) { return Json(each.keeps_limits); }));
  out.rows.add(std::move(columns));
  out.transform = Json::array({flattened(fields), calculated("datum[split(pair, ', ')[0]]", "_x"),
                               calculated("datum[split(pair, ', ')[1]]", "_y"),
                               calculated("datum._keeps ? datum[quantity] : null", "_value")});
  out.description = fmt::format(
      "{} of {} designs, whose other variables differ too; grey: a limit is broken. Variables whose values are words "
      "are left out.",
      table.samples.size(), table.rows);
  return out;
}

// A list from which the reader chooses.
Json choice_of(const char* param, const char* said, const std::vector<std::string>& options) {
  return Json::object(
      {{"name", param},
       {"value", options.front()},
       {"bind",
        Json::object(
            {{"input", "select"}, {"options", texts_json(options)}, {"name", said}, {"element", "#map-choice"}})}});
}

Json map_axis(const char* field, const char* title, bool sampled) {
  Json out = Json::object({{"field", field},
                           {"type", sampled ? "quantitative" : "ordinal"},
                           {"title", title},
                           {"axis", Json::object({{"title", nullptr}, {"labelAngle", 0}, {"labelOverlap", true}})}});
  out.set("scale", sampled ? Json::object({{"zero", false}}) : Json::object({}));
  return out;
}

Json spec_of(MapParts parts, const FrontTable& leaders, bool sampled) {
  const Json x = map_axis("_x", "across", sampled);
  Json y = map_axis("_y", "up", sampled);
  if (!sampled) y.set("sort", "descending");
  const Json colour = Json::object(
      {{"field", "_value"},
       {"type", "quantitative"},
       {"title", "colour"},
       {"legend", Json::object({{"title", nullptr}, {"direction", "horizontal"}, {"gradientLength", 160}})},
       {"scale", Json::object({{"scheme", "viridis"}, {"zero", false}})}});
  Json none = Json::object({{"type", sampled ? "point" : "rect"}, {"style", "other"}, {"tooltip", false}});
  Json kept = Json::object({{"type", sampled ? "point" : "rect"}, {"tooltip", true}});
  (sampled ? kept : none).set("filled", true);
  const auto where = [](const char* test) { return Json::array({Json::object({{"filter", test}})}); };
  const Json layers =
      Json::array({Json::object({{"transform", where("!isValid(datum._value)")},
                                 {"mark", std::move(none)},
                                 {"encoding", Json::object({{"x", x}, {"y", y}})}}),
                   Json::object({{"transform", where("isValid(datum._value)")},
                                 {"mark", std::move(kept)},
                                 {"encoding", Json::object({{"x", x}, {"y", y}, {"color", colour}})}})});
  constexpr const char* names =
      "['colour: ' + quantity, 'across: ' + split(pair, ', ')[0], 'up: ' + split(pair, ', ')[1]]";
  Json spec = vega_lite(parts.description, 380, true);
  spec.set("params", Json::array({choice_of("pair", "Across, up: ", parts.pairs),
                                  choice_of("quantity", "Colour: ", leaders.objectives)}));
  spec.set("title", Json::object({{"text", Json::object({{"expr", names}})}}));
  spec.set("data", Json::object({{"values", std::move(parts.rows)}}));
  spec.set("transform", std::move(parts.transform)).set("layer", layers);
  return spec;
}

}  // namespace

std::optional<Section> map_section(const SweepTable& table, const FrontTable& leaders) {
  // A grid too fine for cells is shown as a sample of it.
  const bool has_cells = std::ranges::any_of(table.maps, [](const SweepTable::Map& map) { return !map.cells.empty(); });
  MapParts parts = has_cells ? parts_of_grid(table, leaders) : parts_of_sample(table, leaders);
  if (parts.pairs.empty()) return std::nullopt;
  parts.description += " Yellow is most. It begins with the first two variables of the study; the lists choose others.";
  Section section{.id = "map", .title = "What two variables do together"};
  section.blocks.emplace_back(
      Widget{"<div class=\"controls\" id=\"map-choice\" role=\"group\" aria-label=\"What the map shows\"></div>\n"});
  std::string description = parts.description;
  Table numbers = std::move(parts.table);
  section.blocks.emplace_back(Figure{.id = "two-variables",
                                     .title = fmt::format("{} by two variables", fmt::join(leaders.objectives, ", ")),
                                     .description = std::move(description),
                                     .content = spec_of(std::move(parts), leaders, !has_cells),
                                     .table = std::move(numbers)});
  return section;
}

}  // namespace coilwright::page
