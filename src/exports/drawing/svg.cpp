#include "exports/drawing/sketch.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "coilwright/text/markup.hpp"

namespace coilwright::exports {
namespace {

// Height of a capital letter over the size of its font: sans-serif fonts have 0.70 to 0.73.
constexpr double cap_height = 0.72;

// In heights of a letter.
constexpr double margin = 1.0;

// In the order of Layer.
constexpr std::array<std::string_view, 9> layer_classes = {"body",      "winding", "magnet", "slit",   "axis",
                                                           "dimension", "note",    "field",  "outline"};

std::string_view class_of(Layer layer) {
  return layer_classes[static_cast<std::size_t>(layer)];
}

// Line widths in heights of a letter of 2.5 mm: 0.5, 0.35 and 0.18 mm on paper.
std::string style_of(double letter) {
  const double wide = 0.2 * letter;
  const double middle = 0.14 * letter;
  const double thin = 0.072 * letter;
  return fmt::format(
      "line, circle, rect {{ fill: none; stroke: #1c2733; stroke-width: {1:.4g}; }}\n"
      "rect.body {{ fill: #f6eadb; }}\n"
      "rect.winding, circle.winding {{ fill: #d9a066; }}\n"
      "line.winding {{ stroke-width: {2:.4g}; }}\n"
      "rect.magnet, circle.magnet {{ fill: #aab4be; }}\n"
      "circle.winding + circle.winding {{ fill: #f6eadb; }}\n"
      ".slit {{ stroke: #b3261e; stroke-width: {0:.4g}; }}\n"
      ".axis {{ stroke-width: {2:.4g}; stroke-dasharray: {3:.4g} {4:.4g} {2:.4g} {4:.4g}; }}\n"
      ".dimension {{ stroke-width: {2:.4g}; }}\n"
      "text {{ font-family: sans-serif; fill: #1c2733; stroke: none; }}\n",
      wide, middle, thin, 4.0 * letter, 0.8 * letter);
}

// Of a map: arrows, and where bodies are.
std::string map_style_of(double letter) {
  return fmt::format(
      ".field {{ stroke: #ffffff; stroke-width: {:.4g}; }}\n"
      ".outline {{ stroke: #000000; stroke-linecap: square; }}\n",
      0.072 * letter);
}

// Places of the part as places of the picture, whose y goes down.
struct Frame {
  Bounds bounds;

  [[nodiscard]] double x(double part) const { return 1e3 * (part - bounds.low.x); }
  [[nodiscard]] double y(double part) const { return 1e3 * (bounds.high.y - part); }

  [[nodiscard]] std::string operator()(const SketchFill& each) const {
    std::string path;
    for (const Bounds& area : each.areas)
      path += fmt::format("M{:.4f} {:.4f}h{:.4f}v{:.4f}h{:.4f}z", x(area.low.x), y(area.high.y),
                          1e3 * (area.high.x - area.low.x), 1e3 * (area.high.y - area.low.y),
                          1e3 * (area.low.x - area.high.x));
    return fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", each.colour, path);
  }
  [[nodiscard]] std::string operator()(const SketchRectangle& each) const {
    return fmt::format("<rect class=\"{}\" x=\"{:.4f}\" y=\"{:.4f}\" width=\"{:.4f}\" height=\"{:.4f}\"/>\n",
                       class_of(each.layer), x(each.low.x), y(each.high.y), 1e3 * (each.high.x - each.low.x),
                       1e3 * (each.high.y - each.low.y));
  }
  [[nodiscard]] std::string operator()(const SketchCircle& each) const {
    return fmt::format("<circle class=\"{}\" cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\"/>\n", class_of(each.layer),
                       x(each.centre.x), y(each.centre.y), 1e3 * each.radius);
  }
  [[nodiscard]] std::string operator()(const SketchLine& each) const {
    return fmt::format("<line class=\"{}\" x1=\"{:.4f}\" y1=\"{:.4f}\" x2=\"{:.4f}\" y2=\"{:.4f}\"/>\n",
                       class_of(each.layer), x(each.from.x), y(each.from.y), x(each.to.x), y(each.to.y));
  }
  [[nodiscard]] std::string operator()(const SketchText& each) const {
    const std::string_view anchor = each.anchor == Anchor::start    ? "start"
                                    : each.anchor == Anchor::middle ? "middle"
                                                                    : "end";
    const std::string turned =
        each.upright ? fmt::format(" transform=\"rotate(-90 {:.4f} {:.4f})\"", x(each.at.x), y(each.at.y)) : "";
    return fmt::format(
        "<text class=\"{}\" x=\"{:.4f}\" y=\"{:.4f}\" font-size=\"{:.4f}\" text-anchor=\"{}\"{}>{}</text>\n",
        class_of(each.layer), x(each.at.x), y(each.at.y), 1e3 * each.height / cap_height, anchor, turned,
        text::escaped(each.text));
  }
};

}  // namespace

std::string svg_of(const Sketch& sketch, double scale, const SvgText& text) {
  Frame frame{.bounds = sketch.bounds()};
  const double edge = margin * sketch.text_height();
  frame.bounds.low = {frame.bounds.low.x - edge, frame.bounds.low.y - edge};
  frame.bounds.high = {frame.bounds.high.x + edge, frame.bounds.high.y + edge};
  const double width = frame.x(frame.bounds.high.x);
  const double height = frame.y(frame.bounds.low.y);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.4f} {:.4f}\" width=\"{:.4f}mm\" height=\"{:.4f}mm\" "
      "role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n<style>\n{}</style>\n",
      width, height, scale * width, scale * height, text::escaped(text.title), text::escaped(text.description),
      style_of(1e3 * sketch.text_height()) + (sketch.fills().empty() ? "" : map_style_of(1e3 * sketch.text_height())));
  out +=
      fmt::format("<rect x=\"0\" y=\"0\" width=\"{:.4f}\" height=\"{:.4f}\" style=\"fill: #ffffff; stroke: none\"/>\n",
                  width, height);
  for (const SketchFill& each : sketch.fills()) out += frame(each);
  for (const SketchRectangle& each : sketch.rectangles()) out += frame(each);
  for (const SketchCircle& each : sketch.circles()) out += frame(each);
  for (const SketchLine& each : sketch.lines()) out += frame(each);
  for (const SketchText& each : sketch.texts()) out += frame(each);
  return out + "</svg>\n";
}

}  // namespace coilwright::exports
