#include "exports/drawing/sketch.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>

namespace coilwright::exports {
namespace {

struct DxfLayer {
  Layer layer{};
  std::string_view name;
  std::string_view colour;  // AutoCAD colour index
  std::string_view line;
};

// Colours: 7 black or white, 1 red, 30 orange, 8 grey, 5 blue.
constexpr std::array layer_table = {
    DxfLayer{Layer::body, "BODY", "7", "CONTINUOUS"},     DxfLayer{Layer::winding, "WINDING", "30", "CONTINUOUS"},
    DxfLayer{Layer::magnet, "MAGNET", "8", "CONTINUOUS"}, DxfLayer{Layer::slit, "SLIT", "1", "CONTINUOUS"},
    DxfLayer{Layer::axis, "AXIS", "8", "CENTER"},         DxfLayer{Layer::dimension, "DIMENSION", "5", "CONTINUOUS"},
    DxfLayer{Layer::note, "NOTE", "7", "CONTINUOUS"},
};

std::string_view name_of(Layer layer) {
  for (const DxfLayer& row : layer_table)
    if (row.layer == layer) return row.name;
  return "0";
}

// A group: its code, then its value, a line each.
void put(std::string& out, int code, std::string_view value) {
  out += fmt::format("{:>3}\n{}\n", code, value);
}

void put(std::string& out, int code, double value) {
  put(out, code, fmt::format("{:.6f}", value));
}

// Groups that are the same in every file.
using Groups = std::initializer_list<std::pair<int, std::string_view>>;
void put(std::string& out, const Groups& groups) {
  for (const auto& [code, value] : groups) put(out, code, value);
}

// Its x has the code, its y ten more, its z twenty more.
void put_point(std::string& out, int code, Point at) {
  put(out, code, 1e3 * at.x);
  put(out, code + 10, 1e3 * at.y);
  put(out, code + 20, 0.0);
}

std::string ascii(std::string_view text) {
  constexpr std::string_view diameter = "⌀";
  std::string out;
  while (!text.empty()) {
    if (text.starts_with(diameter)) {
      out += "%%c";
      text.remove_prefix(diameter.size());
      continue;
    }
    const auto byte = static_cast<unsigned char>(text.front());
    if (byte >= 0x20 && byte < 0x7f) out += text.front();
    if (byte >= 0xc0 || byte < 0x20) out += '?';  // what continues a letter adds nothing
    text.remove_prefix(1);
  }
  return out;
}

void put_header(std::string& out, const Bounds& bounds) {
  put(out, {{0, "SECTION"}, {2, "HEADER"}, {9, "$ACADVER"}, {1, "AC1009"}, {9, "$EXTMIN"}});
  put_point(out, 10, bounds.low);
  put(out, 9, "$EXTMAX");
  put_point(out, 10, bounds.high);
  put(out, 0, "ENDSEC");
}

void put_line_types(std::string& out, double letter) {
  put(out, {{0, "TABLE"}, {2, "LTYPE"}, {70, "2"}, {0, "LTYPE"}, {2, "CONTINUOUS"}, {70, "0"}, {3, "Solid line"}});
  put(out, {{72, "65"}, {73, "0"}, {40, "0.000000"}, {0, "LTYPE"}, {2, "CENTER"}, {70, "0"}, {3, "Centre line"}});
  const std::array dashes = {4.0 * letter, -0.8 * letter, 0.4 * letter, -0.8 * letter};  // negative: a gap
  put(out, {{72, "65"}, {73, fmt::format("{}", dashes.size())}});
  put(out, 40, 6.0 * letter);
  for (const double dash : dashes) put(out, 49, dash);
  put(out, 0, "ENDTAB");
}

void put_layers(std::string& out) {
  put(out, {{0, "TABLE"}, {2, "LAYER"}, {70, fmt::format("{}", layer_table.size())}});
  for (const DxfLayer& row : layer_table)
    put(out, {{0, "LAYER"}, {2, row.name}, {70, "0"}, {62, row.colour}, {6, row.line}});
  put(out, 0, "ENDTAB");
}

void put_text_style(std::string& out) {
  put(out, {{0, "TABLE"}, {2, "STYLE"}, {70, "1"}, {0, "STYLE"}, {2, "STANDARD"}, {70, "0"}, {40, "0.000000"}});
  put(out, {{41, "1.000000"}, {50, "0.000000"}, {71, "0"}, {42, "2.500000"}, {3, "txt"}, {4, ""}, {0, "ENDTAB"}});
}

void begin_entity(std::string& out, std::string_view kind, Layer layer) {
  put(out, 0, kind);
  put(out, 8, name_of(layer));
}

void put_line(std::string& out, Layer layer, Point from, Point to) {
  begin_entity(out, "LINE", layer);
  put_point(out, 10, from);
  put_point(out, 11, to);
}

void put_rectangle(std::string& out, const SketchRectangle& each) {
  const Point a = each.low;
  const Point b{each.high.x, each.low.y};
  const Point c = each.high;
  const Point d{each.low.x, each.high.y};
  put_line(out, each.layer, a, b);
  put_line(out, each.layer, b, c);
  put_line(out, each.layer, c, d);
  put_line(out, each.layer, d, a);
}

void put_text(std::string& out, const SketchText& each) {
  begin_entity(out, "TEXT", each.layer);
  put_point(out, 10, each.at);
  put(out, 40, 1e3 * each.height);
  put(out, 1, ascii(each.text));
  if (each.upright) put(out, 50, 90.0);
  if (each.anchor == Anchor::start) return;
  put(out, 72, each.anchor == Anchor::middle ? "1" : "2");
  put_point(out, 11, each.at);
}

}  // namespace

std::string dxf_of(const Sketch& sketch) {
  std::string out;
  put(out, 999, "lengths in mm");
  put_header(out, sketch.bounds());
  put(out, {{0, "SECTION"}, {2, "TABLES"}});
  put_line_types(out, 1e3 * sketch.text_height());
  put_layers(out);
  put_text_style(out);
  put(out, {{0, "ENDSEC"}, {0, "SECTION"}, {2, "ENTITIES"}});
  for (const SketchRectangle& each : sketch.rectangles()) put_rectangle(out, each);
  for (const SketchCircle& each : sketch.circles()) {
    begin_entity(out, "CIRCLE", each.layer);
    put_point(out, 10, each.centre);
    put(out, 40, 1e3 * each.radius);
  }
  for (const SketchLine& each : sketch.lines()) put_line(out, each.layer, each.from, each.to);
  for (const SketchText& each : sketch.texts()) put_text(out, each);
  put(out, {{0, "ENDSEC"}, {0, "EOF"}});
  return out;
}

}  // namespace coilwright::exports
