#include "formats/data/layout_format.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

// In a column's unit: what makes one finite number of another.
constexpr Rule number_rule = Rule::between(-1e12, 1e12);
constexpr Rule sampling_rule = Rule::between(1e-6, 1e9);  // Hz
constexpr Rule skip_rule = Rule::between(0.0, 1e6);       // lines
constexpr std::string_view others_word = "others";

double read_factor(ObjectReader& in) {
  const auto node = in.find("factor");
  if (!node) return 1.0;
  const double factor = node->number(number_rule);
  if (std::abs(factor) < 1e-12) throw node->error("must not be 0");
  return factor;
}

units::Unit unit_of_ours(const Node& node, const std::string& name) {
  const auto split = units::split_unit(name);
  if (!split)
    throw node.error(
        R"(must be a column of ours with the unit of the file's numbers, such as "time_ms" or "current_A")");
  return split->unit;
}

CsvColumn read_column(const Node& node) {
  CsvColumn column{.source = node.key()};
  if (node.kind() == Node::Kind::text) {
    column.name = node.text();
    (void)unit_of_ours(node, column.name);
    return column;
  }
  return read_object(node, [&](ObjectReader& in) {
    const Node as = in.at("as");
    column.name = as.text();
    const units::Unit unit = unit_of_ours(as, column.name);
    column.factor = read_factor(in);
    column.offset = in.number_or("offset", 0.0, number_rule);
    if (const auto wraps = in.find_not_null("wraps_deg")) {
      if (unit.dimension != "angle") throw wraps->error_without_value("must be there for an angle only");
      const double period = wraps->number(positive);
      if (period != 180.0 && period != 360.0) throw wraps->error("must be 180 or 360");
      column.period = units::from_si(wraps->quantity(), unit);
    }
    return column;
  });
}

CsvPoint read_point(const Node& node, std::vector<std::pair<std::string, Node>>& named) {
  const std::vector<Node> both = node.elements(Length::exactly(2));
  if (both[0].kind() == Node::Kind::number) return std::array{both[0].number(number_rule), both[1].number(number_rule)};
  for (const Node& each : both) named.emplace_back(each.text(), each);
  return std::array{both[0].text(), both[1].text()};
}

std::array<CsvPoint, 2> read_line(const Node& node, std::vector<std::pair<std::string, Node>>& named) {
  const std::vector<Node> points = node.elements(Length::exactly(2));
  return {read_point(points[0], named), read_point(points[1], named)};
}

CsvMarkers read_markers(const Node& node, std::vector<std::pair<std::string, Node>>& named) {
  CsvMarkers markers{.name = node.key()};
  const auto split = units::split_unit(markers.name);
  if (!split || split->unit.dimension != "angle")
    throw node.error_without_value(R"(must be called by an angle of ours: "bending_angle_deg", "theta1_deg", ..)");
  return read_object(node, [&](ObjectReader& in) {
    markers.line = read_line(in.at("line"), named);
    if (const auto against = in.find_not_null("against")) markers.against = read_line(*against, named);
    markers.y_is_up = in.choice_or("y", false, {{"down", false}, {"up", true}});
    markers.factor = read_factor(in);
    markers.offset = in.number_or("offset", 0.0, number_rule);
    return markers;
  });
}

void read_ignore(const Node& node, LayoutEntry& out) {
  out.layout.ignore.clear();
  out.layout.ignore_others = node.kind() == Node::Kind::text && node.text() == others_word;
  if (out.layout.ignore_others) return;
  if (node.kind() != Node::Kind::array)
    throw node.error(R"(must be "others", or an array of names and positions such as ["frame", "#1"])");
  std::set<std::string_view> met;
  for (const Node& element : node.elements()) {
    if (element.kind() == Node::Kind::number)
      throw element.error(R"(must be a column's name, or its position as a text: "#1" is the first)");
    if (!met.insert(element.text()).second) throw element.error("must not be there twice");
    out.layout.ignore.push_back(element.text());
    out.named.emplace_back(element.text(), element);
  }
}

Json point_json(const CsvPoint& point) {
  if (const auto* place = std::get_if<std::array<double, 2>>(&point)) return Json::numbers(*place);
  const auto& sources = std::get<std::array<std::string, 2>>(point);
  return Json::array({sources[0], sources[1]});
}

Json line_json(const std::array<CsvPoint, 2>& line) {
  return Json::array({point_json(line[0]), point_json(line[1])});
}

Json column_json(const CsvColumn& column) {
  if (column.factor == 1.0 && column.offset == 0.0 && column.period == 0.0) return column.name;
  Json out = Json::object({{"as", column.name}});
  if (column.factor != 1.0) out.set("factor", column.factor);
  if (column.offset != 0.0) out.set("offset", column.offset);
  if (column.period != 0.0)
    out.set("wraps_deg", std::round(units::to_memory(column.period, column.name) / units::to_memory(1.0, "x_deg")));
  return out;
}

Json markers_json(const CsvMarkers& markers) {
  Json out = Json::object({{"line", line_json(markers.line)}});
  if (markers.against) out.set("against", line_json(*markers.against));
  if (markers.y_is_up) out.set("y", "up");
  if (markers.factor != 1.0) out.set("factor", markers.factor);
  if (markers.offset != 0.0) out.set("offset", markers.offset);
  return out;
}

}  // namespace

LayoutEntry read_layout(ObjectReader& in, CsvLayout base) {
  LayoutEntry out{.layout = std::move(base)};
  if (const auto columns = in.find_not_null("columns")) {
    out.layout.columns.clear();
    columns->expect_object();
    for (const Node& each : columns->members()) {
      if (each.key() == comment_key) continue;
      out.layout.columns.push_back(read_column(each));
      out.named.emplace_back(each.key(), each);
    }
  }
  if (const auto markers = in.find_not_null("markers")) {
    out.layout.markers.clear();
    markers->expect_object();
    for (const Node& each : markers->members())
      if (each.key() != comment_key) out.layout.markers.push_back(read_markers(each, out.named));
  }
  if (const auto ignore = in.find_not_null("ignore")) read_ignore(*ignore, out);
  if (const auto rate = in.find_not_null("sampling_rate_Hz")) {
    out.layout.sampling_rate = rate->quantity(sampling_rule);
    out.named.emplace_back("sampling_rate_Hz", *rate);
  }
  if (const auto skip = in.find_not_null("skip_lines")) out.layout.skip_lines = skip->integer<std::size_t>(skip_rule);
  if (const auto separator = in.find_not_null("separator"))
    out.layout.separator = separator->choice<char>({{",", ','}, {";", ';'}, {"\t", '\t'}, {"|", '|'}, {" ", ' '}});
  if (const auto decimal = in.find_not_null("decimal"))
    out.layout.decimal = decimal->choice<char>({{".", '.'}, {",", ','}});
  return out;
}

Json with_layout(Json out, const CsvLayout& layout) {
  if (layout.sampling_rate) out.set("sampling_rate_Hz", *layout.sampling_rate);
  if (!layout.columns.empty()) {
    Json columns = Json::object();
    for (const CsvColumn& each : layout.columns) columns.set(each.source, column_json(each));
    out.set("columns", std::move(columns));
  }
  if (!layout.markers.empty()) {
    Json markers = Json::object();
    for (const CsvMarkers& each : layout.markers) markers.set(each.name, markers_json(each));
    out.set("markers", std::move(markers));
  }
  if (layout.ignore_others) out.set("ignore", others_word);
  if (!layout.ignore.empty()) {
    Json ignore = Json::array();
    for (const std::string& each : layout.ignore) ignore.add(each);
    out.set("ignore", std::move(ignore));
  }
  if (layout.skip_lines > 0) out.set("skip_lines", layout.skip_lines);
  if (layout.separator) out.set("separator", std::string(1, *layout.separator));
  if (layout.decimal) out.set("decimal", std::string(1, *layout.decimal));
  return out;
}

}  // namespace coilwright::formats
