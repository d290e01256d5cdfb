#include "page/front.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coilwright/page/chart.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

using text::Json;

constexpr std::size_t most_others = 3000;
constexpr std::size_t most_lines = 400;
constexpr const char* scene_axes[] = {"x", "y", "z"};

std::string sense_of(const FrontTable& front, std::size_t objective) {
  return fmt::format("{} ({} is better)", front.objectives[objective], front.largest[objective] ? "more" : "less");
}

Json position(const FrontTable& front, const OtherDesigns& others, std::size_t objective) {
  Json scale = Json::object({{"zero", false}});
  if (!others.axes.empty()) scale.set("domain", Json::numbers(others.axes[objective])).set("nice", false);
  return Json::object({{"field", scene_axes[objective]},
                       {"type", "quantitative"},
                       {"title", sense_of(front, objective)},
                       {"scale", std::move(scale)}});
}

Json rows_of(const FrontTable& front) {
  Json rows = Json::array();
  const bool shapes = front.texts.has("configuration");
  for (std::size_t row = 0; row < front.rows(); ++row) {
    Json each = Json::object({{"row", row}});
    for (std::size_t i = 0; i < front.objectives.size(); ++i)
      each.set(scene_axes[i], front.texts.required_number(front.objectives[i], row));
    each.set("kind",
             shapes ? "configuration " + front.texts.column("configuration")[row] : std::string("on the front"));
    rows.add(std::move(each));
  }
  return rows;
}

Json rows_of(const OtherDesigns& others) {
  Json rows = Json::array();
  for (const OtherDesigns::Group& group : others.groups)
    for (const std::vector<double>& values : group.values) {
      Json each = Json::object({{"kind", group.name}});
      for (std::size_t i = 0; i < values.size(); ++i) each.set(scene_axes[i], values[i]);
      rows.add(std::move(each));
    }
  return rows;
}

std::vector<std::string> kinds_of(const FrontTable& front) {
  std::vector<std::string> kinds;
  if (!front.texts.has("configuration")) return {"on the front"};
  for (const std::string& letter : front.texts.column("configuration"))
    if (std::ranges::find(kinds, "configuration " + letter) == kinds.end()) kinds.push_back("configuration " + letter);
  std::ranges::sort(kinds);
  return kinds;
}

// Shapes that are told apart without colour: filled ones on the front, crosses for what breaks a limit.
Json shape_scale(const FrontTable& front) {
  static constexpr const char* shapes[] = {"circle", "square", "triangle-up", "diamond"};
  Json domain = Json::array();
  Json range = Json::array();
  std::size_t i = 0;
  for (const std::string& kind : kinds_of(front)) {
    domain.add(kind);
    range.add(shapes[i++ % std::size(shapes)]);
  }
  domain.add("beaten by the front").add("breaks a limit");
  range.add("stroke").add("cross");
  return Json::object({{"domain", std::move(domain)}, {"range", std::move(range)}});
}

Json named(const char* name) {
  return Json::object({{"name", name}});
}

Json shape_of(const FrontTable& front) {
  return Json::object({{"field", "kind"}, {"type", "nominal"}, {"title", nullptr}, {"scale", shape_scale(front)}});
}

Figure scatter(const FrontTable& front, const OtherDesigns& others) {
  const Json x = position(front, others, 0);
  const Json y = position(front, others, 1);
  Json on_front = Json::object({{"x", x}, {"y", y}, {"shape", shape_of(front)}});
  const bool coloured = front.objectives.size() > 2;
  if (coloured)
    on_front.set("color",
                 Json::object({{"field", "z"},
                               {"type", "quantitative"},
                               {"title", sense_of(front, 2)},
                               {"legend", Json::object({{"direction", "horizontal"}, {"gradientLength", 160}})},
                               {"scale", Json::object({{"scheme", "viridis"}})}}));
  Json mark =
      Json::object({{"type", "point"}, {"filled", true}, {"size", front.rows() > 2000 ? 22 : 70}, {"opacity", 1}});
  if (!coloured) mark.set("style", "front");
  const Json layers = Json::array(
      {Json::object({{"data", named("others")},
                     {"mark", Json::object({{"type", "point"}, {"style", "other"}, {"size", 36}, {"tooltip", false}})},
                     {"encoding", Json::object({{"x", x}, {"y", y}, {"shape", shape_of(front)}})}}),
       Json::object({{"name", "designs"}, {"data", named("front")}, {"mark", mark}, {"encoding", on_front}})});
  std::vector<std::string> groups;
  for (const OtherDesigns::Group& group : others.groups) {
    std::vector<std::string> remarks;
    if (group.outside > 0) remarks.push_back(fmt::format("{} outside of the axes", group.outside));
    if (group.values.size() + group.outside < group.count)
      remarks.push_back(fmt::format("{} of the others shown", group.values.size()));
    groups.push_back(fmt::format("{} that {}{}", group.count, group.said,
                                 remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, ", "))));
  }
  const std::string behind = groups.empty() ? "" : fmt::format(" Behind them, in grey: {}.", fmt::join(groups, ", "));
  const std::string description =
      fmt::format("{} designs of the front by {} and {}{}.{} A click selects the nearest design; so does the slider.",
                  front.rows(), front.objectives[0], front.objectives[1],
                  coloured ? fmt::format(", coloured by {}", front.objectives[2]) : "", behind);
  Json spec = vega_lite(description, 420, false);
  spec.set("datasets", Json::object({{"front", rows_of(front)}, {"others", rows_of(others)}})).set("layer", layers);
  return {.id = "front", .title = "Designs of the front", .description = description, .content = std::move(spec)};
}

// A column between its least and its greatest value; a text by its place among the texts.
struct Coordinate {
  std::string name;
  std::vector<double> shares;  // a row; 0 to 1
  std::string least;
  std::string greatest;
};

std::optional<Coordinate> coordinate_of(const FrontTable& front, const std::string& name) {
  const std::vector<std::string>& fields = front.texts.column(name);
  std::vector<std::string> texts;
  std::vector<double> values;
  for (const std::string& field : fields)
    if (const std::optional<double> number = text::number_in(field)) values.push_back(*number);
  if (values.size() != fields.size()) {
    texts = fields;
    std::ranges::sort(texts);
    texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
    values.clear();
    for (const std::string& field : fields)
      values.push_back(static_cast<double>(std::ranges::find(texts, field) - texts.begin()));
  }
  const auto [least, greatest] = std::ranges::minmax(values);
  if (least == greatest) return std::nullopt;
  Coordinate out{.name = name,
                 .shares = {},
                 .least = texts.empty() ? short_number(least) : texts.front(),
                 .greatest = texts.empty() ? short_number(greatest) : texts.back()};
  for (const double value : values) out.shares.push_back((value - least) / (greatest - least));
  return out;
}

Json parallel_layer(const char* data, Json mark) {
  return Json::object(
      {{"data", named(data)},
       {"transform", Json::array({Json::object({{"flatten", Json::array({"axis", "share"})}})})},
       {"mark", std::move(mark)},
       {"encoding",
        Json::object(
            {{"x", Json::object(
                       {{"field", "axis"},
                        {"type", "ordinal"},
                        {"sort", nullptr},
                        {"title", nullptr},
                        {"axis",
                         Json::object(
                             {{"labelAngle", -60}, {"grid", true}, {"labelLimit", 200}, {"labelOverlap", false}})}})},
             {"y", Json::object({{"field", "share"},
                                 {"type", "quantitative"},
                                 {"axis", nullptr},
                                 {"scale", Json::object({{"domain", Json::array({-0.26, 1.14})}, {"nice", false}})}})},
             {"detail", Json::object({{"field", "row"}, {"type", "nominal"}})}})}});
}

// Where scene_axes stand close, as on a phone, numbers lean so that they do not run into each other.
Json where_close(const char* close, const char* otherwise) {
  return Json::object({{"expr", fmt::format("width < 46 * domain('x').length ? {} : {}", close, otherwise)}});
}

Json end_layer(const char* field, double place, const char* baseline, const char* align_where_close) {
  return Json::object(
      {{"data", named("ends")},
       {"mark", Json::object({{"type", "text"},
                              {"style", "end"},
                              {"angle", where_close("-60", "0")},
                              {"align", where_close(align_where_close, "'center'")},
                              {"baseline", where_close("'middle'", baseline)}})},
       {"encoding", Json::object({{"x", Json::object({{"field", "axis"}, {"type", "ordinal"}, {"sort", nullptr}})},
                                  {"y", Json::object({{"datum", place}, {"type", "quantitative"}})},
                                  {"text", Json::object({{"field", field}, {"type", "nominal"}})}})}});
}

std::optional<Figure> parallel(const FrontTable& front) {
  std::vector<Coordinate> coordinates;
  for (const std::string& name : shown_columns(front))
    if (std::optional<Coordinate> each = coordinate_of(front, name)) coordinates.push_back(*std::move(each));
  if (coordinates.size() < 2) return std::nullopt;
  Json axis = Json::array();
  Json ends = Json::array();
  for (const Coordinate& each : coordinates) {
    axis.add(each.name);
    ends.add(Json::object({{"axis", each.name}, {"least", each.least}, {"greatest", each.greatest}}));
  }
  Json lines = Json::array();
  const std::vector<std::size_t> rows = even_choice(front.rows(), most_lines);
  for (const std::size_t row : rows) {
    Json shares = Json::array();
    for (const Coordinate& each : coordinates) shares.add(each.shares[row]);
    lines.add(Json::object({{"row", row}, {"axis", axis}, {"share", std::move(shares)}}));
  }
  Json first = Json::array();
  for (const Coordinate& each : coordinates) first.add(each.shares.front());
  const Json selected = Json::array({Json::object({{"row", 0}, {"axis", axis}, {"share", std::move(first)}})});
  const std::string description = fmt::format(
      "A line for each of {} designs through its objectives and variables, each axis from the least value of the front "
      "at the bottom to the greatest on top. The selected design is the thick line.",
      rows.size() == front.rows() ? fmt::format("the {}", rows.size())
                                  : fmt::format("{} of the {}", rows.size(), front.rows()));
  Json spec = vega_lite(description, 380, false);
  spec.set("datasets", Json::object({{"lines", std::move(lines)}, {"ends", std::move(ends)}, {"selected", selected}}));
  spec.set(
      "layer",
      Json::array(
          {parallel_layer("lines", Json::object({{"type", "line"}, {"style", "design"}})),
           parallel_layer("selected", Json::object({{"type", "line"}, {"style", "selected-line"}, {"point", true}})),
           end_layer("least", -0.02, "'top'", "'right'"), end_layer("greatest", 1.02, "'bottom'", "'left'")}));
  return Figure{.id = "parallel",
                .title = "Objectives and variables side by side",
                .description = description,
                .content = std::move(spec)};
}

using Values = std::vector<double>;  // one for each objective

// The values of the designs of a status that have all of them.
std::vector<Values> values_of(const text::CsvTexts& all, std::string_view status,
                              const std::vector<std::string>& objectives) {
  std::vector<Values> out;
  for (std::size_t row = 0; row < all.rows(); ++row) {
    if (all.column("status")[row] != status) continue;
    Values each;
    for (const std::string& objective : objectives)
      if (const auto value = all.number(objective, row)) each.push_back(*value);
    if (each.size() == objectives.size()) out.push_back(std::move(each));
  }
  return out;
}

std::vector<std::array<double, 2>> axes_around(const std::vector<Values>& front, const std::vector<Values>& feasible) {
  constexpr double room = 0.04;  // of the axis, on either side
  std::vector<std::array<double, 2>> out;
  if (front.empty() && feasible.empty()) return out;
  for (std::size_t objective = 0; objective < 2; ++objective) {
    std::array<double, 2> axis{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const std::vector<Values>* group : {&front, &feasible})
      for (const Values& each : *group) axis = {std::min(axis[0], each[objective]), std::max(axis[1], each[objective])};
    const double span = axis[1] > axis[0] ? axis[1] - axis[0] : std::max(std::abs(axis[0]), 1.0);
    out.push_back({axis[0] - room * span, axis[1] + room * span});
  }
  return out;
}

bool is_within(const std::vector<std::array<double, 2>>& axes, const Values& values) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (values[i] < axes[i][0] || values[i] > axes[i][1]) return false;
  return true;
}

}  // namespace

OtherDesigns read_other_designs(const std::filesystem::path& folder, const text::Node& result,
                                const FrontTable& front) {
  const text::CsvTexts all = text::read_csv_texts(folder / "evaluations.csv", [&](std::string_view name) {
    return name == "status" || std::ranges::find(front.objectives, name) != front.objectives.end();
  });
  require_rows(all, evaluations_of(result));
  std::vector<Values> on_front;
  for (std::size_t row = 0; row < front.rows(); ++row) {
    Values each;
    for (const std::string& objective : front.objectives) each.push_back(front.texts.required_number(objective, row));
    on_front.push_back(std::move(each));
  }
  std::vector<Values> feasible = values_of(all, "ok", front.objectives);
  std::vector<Values> infeasible = values_of(all, "infeasible", front.objectives);
  OtherDesigns others;
  others.axes = axes_around(on_front, feasible);
  // Those on the front are among the feasible ones, and would lie under its own marks.
  std::ranges::sort(on_front);
  std::erase_if(feasible, [&](const Values& each) { return std::ranges::binary_search(on_front, each); });
  const auto add = [&](const char* name, const char* said, std::vector<Values> values) {
    OtherDesigns::Group group{.name = name, .said = said, .count = values.size(), .outside = 0, .values = {}};
    group.outside = std::erase_if(values, [&](const Values& each) { return !is_within(others.axes, each); });
    for (const std::size_t i : even_choice(values.size(), most_others)) group.values.push_back(values[i]);
    if (group.count > 0) others.groups.push_back(std::move(group));
  };
  add("breaks a limit", "break a limit", std::move(infeasible));
  add("beaten by the front", "the front beats", std::move(feasible));
  return others;
}

std::vector<Figure> front_figures(const FrontTable& front, const OtherDesigns& others) {
  std::vector<Figure> figures;
  if (front.rows() == 0 && others.groups.empty()) return figures;
  figures.push_back(scatter(front, others));
  if (std::optional<Figure> each = front.rows() > 0 ? parallel(front) : std::nullopt)
    figures.push_back(*std::move(each));
  return figures;
}

}  // namespace coilwright::page
