#include "coilwright/page/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace coilwright::page {
namespace {

using text::Json;

constexpr std::size_t most_table_rows = 400;
// Room for the words beside bars, by the width that there is.
constexpr const char* wide_labels = "containerSize()[0] > 700 ? 420 : 170";

// In the order of Mark.
constexpr std::array<std::string_view, 6> mark_kinds = {"line", "steps", "points", "dots", "faint", "level"};

std::string_view kind_of(Mark mark) {
  return mark_kinds[static_cast<std::size_t>(mark)];
}

bool has_name(const Series& series, std::optional<Mark> mark) {
  return series.mark != Mark::level && (!mark || series.mark == *mark);
}

Json names_of(const Chart& chart, std::optional<Mark> mark) {
  Json names = Json::array();
  if (!mark && !chart.colour_order.empty()) {
    for (const std::string& name : chart.colour_order) names.add(name);
    return names;
  }
  for (const Series& each : chart.series)
    if (has_name(each, mark)) names.add(each.name);
  return names;
}

// Colours are numbered through all series, so that no two share one; what a layer draws is in its own legend, with the
// symbols by which it is drawn.
Json by_series(const Chart& chart, std::optional<Mark> domain, Mark legend, std::optional<Json> range = std::nullopt) {
  Json scale = Json::object({{"domain", names_of(chart, domain)}});
  if (range) scale.set("range", *std::move(range));
  return Json::object({{"field", "series"},
                       {"type", "nominal"},
                       {"sort", nullptr},
                       {"title", nullptr},
                       {"scale", std::move(scale)},
                       {"legend", Json::object({{"values", names_of(chart, legend)}})}});
}

Json axis_of(const char* field, const std::string& title, AxisScale scale) {
  Json out = Json::object({{"field", field}, {"type", "quantitative"}, {"title", title}});
  out.set("scale", scale == AxisScale::logarithmic ? Json::object({{"type", "log"}})
                                                   : Json::object({{"zero", false}, {"nice", true}}));
  return out;
}

Json filter(Mark mark) {
  return Json::array({Json::object({{"filter", fmt::format("datum.kind === '{}'", kind_of(mark))}})});
}

Json mark_of(Mark mark) {
  switch (mark) {
    case Mark::line:
      return Json::object({{"type", "line"}, {"strokeWidth", 2}});
    case Mark::steps:
      return Json::object({{"type", "line"}, {"strokeWidth", 2}, {"interpolate", "step-after"}});
    case Mark::dots:
      return Json::object({{"type", "point"}, {"size", 16}, {"opacity", 0.8}, {"strokeWidth", 1.2}});
    case Mark::points:
      return Json::object({{"type", "point"}, {"size", 50}, {"filled", false}, {"strokeWidth", 1.5}});
    default:
      return Json::object({{"type", "point"}, {"size", 14}, {"opacity", 0.45}, {"strokeWidth", 1}});
  }
}

// A dash of its own for each line, long enough that its colour is still seen.
Json dashes(const Chart& chart, Mark mark) {
  static const std::vector<std::vector<double>> patterns = {{1, 0}, {8, 4}, {3, 3}, {12, 3, 3, 3}, {16, 5}, {5, 2}};
  Json out = Json::array();
  std::size_t count = 0;
  for (const Series& each : chart.series)
    if (each.mark == mark) out.add(Json::numbers(patterns[count++ % patterns.size()]));
  return out;
}

Json layer_of(const Chart& chart, Mark mark) {
  const bool drawn = mark == Mark::line || mark == Mark::steps;
  Json encoding = Json::object({{"x", axis_of("x", chart.x_title, chart.x_scale)},
                                {"y", axis_of("y", chart.y_title, chart.y_scale)},
                                {"color", by_series(chart, std::nullopt, mark)}});
  if (drawn) {
    encoding.set("strokeDash", by_series(chart, mark, mark, dashes(chart, mark)));
    encoding.set("order", Json::object({{"field", "place"}, {"type", "quantitative"}}));
  } else {
    encoding.set("shape", by_series(chart, mark, mark));
  }
  return Json::object({{"transform", filter(mark)}, {"mark", mark_of(mark)}, {"encoding", std::move(encoding)}});
}

// A line across with its name on it.
void add_level(Json& layers, const Chart& chart, const Series& level) {
  const Json data =
      Json::object({{"values", Json::array({Json::object({{"y", level.y.front()}, {"name", level.name}})})}});
  const Json y = axis_of("y", chart.y_title, chart.y_scale);
  layers.add(Json::object({{"data", data},
                           {"mark", Json::object({{"type", "rule"}, {"style", "level"}})},
                           {"encoding", Json::object({{"y", y}})}}));
  layers.add(Json::object(
      {{"data", data},
       {"mark", Json::object({{"type", "text"}, {"style", "level-name"}, {"align", "right"}, {"baseline", "bottom"}})},
       {"encoding", Json::object({{"y", y},
                                  {"x", Json::object({{"value", "width"}})},
                                  {"text", Json::object({{"field", "name"}, {"type", "nominal"}})}})}}));
}

bool has(const Chart& chart, Mark mark) {
  return std::ranges::any_of(chart.series, [mark](const Series& each) { return each.mark == mark; });
}

Json data_of(const Chart& chart) {
  Json rows = Json::array();
  for (const Series& each : chart.series) {
    if (each.mark == Mark::level) continue;
    Json places = Json::array();
    for (std::size_t i = 0; i < each.x.size(); ++i) places.add(i);
    rows.add(Json::object({{"series", each.name},
                           {"kind", kind_of(each.mark)},
                           {"place", std::move(places)},
                           {"x", Json::numbers(each.x)},
                           {"y", Json::numbers(each.y)}}));
  }
  return Json::object({{"values", std::move(rows)}});
}

Table table_of(const Chart& chart) {
  Table table{.header = {"series", chart.x_title, chart.y_title}};
  std::size_t count = 0;
  for (const Series& each : chart.series) count += each.y.size();
  const std::size_t every = (count + most_table_rows - 1) / most_table_rows;
  for (const Series& each : chart.series)
    for (std::size_t i = 0; i < each.y.size(); i += every)
      table.rows.push_back(
          {each.name, each.x.empty() ? "" : fmt::format("{:.6g}", each.x[i]), fmt::format("{:.6g}", each.y[i])});
  if (every > 1) table.note = fmt::format("one row in {} of {}", every, count);
  return table;
}

// How full the bars of so many groups are, the first ones most.
Json fillings(std::size_t groups) {
  constexpr double full = 1.0;
  constexpr double faint = 0.45;
  Json out = Json::array();
  for (std::size_t i = 0; i < groups; ++i)
    out.add(groups < 2 ? full : full - (full - faint) * static_cast<double>(i) / static_cast<double>(groups - 1));
  return out;
}

}  // namespace

Json vega_lite(const std::string& description, std::size_t height, bool resizes, const char* autosize) {
  Json size = Json::object({{"type", autosize}, {"contains", "padding"}});
  if (resizes) size.set("resize", true);
  return Json::object({{"$schema", "https://vega.github.io/schema/vega-lite/v6.json"},
                       {"description", description},
                       {"width", "container"},
                       {"height", height},
                       {"autosize", std::move(size)}});
}

Figure figure_of(const Chart& chart) {
  Json layers = Json::array();
  for (const Mark mark : {Mark::faint, Mark::steps, Mark::line, Mark::dots, Mark::points})
    if (has(chart, mark)) layers.add(layer_of(chart, mark));
  for (const Series& each : chart.series)
    if (each.mark == Mark::level) add_level(layers, chart, each);
  Json spec = vega_lite(fmt::format("{}. {}", chart.title, chart.description), 280, true);
  spec.set("data", data_of(chart));
  spec.set("transform", Json::array({Json::object({{"flatten", Json::array({"place", "x", "y"})}})}));
  spec.set("layer", std::move(layers));
  const Json own = Json::object({{"color", "independent"}, {"shape", "independent"}, {"strokeDash", "independent"}});
  spec.set("resolve", Json::object({{"scale", own}, {"legend", own}}));
  return {.id = chart.id,
          .title = chart.title,
          .description = chart.description,
          .content = std::move(spec),
          .table = table_of(chart)};
}

Figure figure_of(const BarChart& chart) {
  Json rows = Json::array();
  Table table{.header = {chart.label_title, chart.value_title, ""}};
  Json groups = Json::array();
  std::vector<std::string> seen;
  std::set<std::string> labels;
  for (const Bar& bar : chart.bars) {
    rows.add(Json::object({{"label", bar.label}, {"value", bar.value}, {"group", bar.group}}));
    table.rows.push_back({bar.label, fmt::format("{:.6g}", bar.value), bar.group});
    labels.insert(bar.label);
    if (std::ranges::find(seen, bar.group) != seen.end()) continue;
    seen.push_back(bar.group);
    groups.add(bar.group);
  }
  const auto group = [&](std::string_view type, Json scale) {
    scale.set("domain", groups);
    return Json::object(
        {{"field", "group"}, {"type", type}, {"title", nullptr}, {"sort", nullptr}, {"scale", std::move(scale)}});
  };
  Json encoding = Json::object(
      {{"y", Json::object({{"field", "label"},
                           {"type", "nominal"},
                           {"sort", nullptr},
                           {"title", nullptr},
                           {"axis", Json::object({{"labelLimit", Json::object({{"expr", wide_labels}})}})}})},
       {"x", Json::object({{"field", "value"},
                           {"type", "quantitative"},
                           {"title", chart.value_title},
                           {"scale", Json::object({{"zero", !chart.symbols}})}})},
       {"color", group("nominal", Json::object({}))}});
  // A group is told by more than its colour: by its symbol, or by how full its bars are.
  if (chart.symbols)
    encoding.set("shape", group("nominal", Json::object({})));
  else
    encoding.set("opacity", group("ordinal", Json::object({{"range", fillings(seen.size())}})));
  Json spec = vega_lite(fmt::format("{}. {}", chart.title, chart.description), 22 * labels.size(), true, "fit-x");
  spec.set("data", Json::object({{"values", std::move(rows)}}));
  spec.set("mark", chart.symbols ? Json::object({{"type", "point"}, {"size", 70}, {"filled", true}})
                                 : Json::object({{"type", "bar"}}));
  spec.set("encoding", std::move(encoding));
  return {.id = chart.id,
          .title = chart.title,
          .description = chart.description,
          .content = std::move(spec),
          .table = std::move(table)};
}

}  // namespace coilwright::page
