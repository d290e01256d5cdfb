#include "exports/drawing/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coilwright::exports {
namespace {

// In heights of a capital letter.
constexpr double letter_width = 0.8;
constexpr double above_line = 0.35;
constexpr double line_spacing = 1.4;
constexpr double beside = 0.6;
constexpr double overhang = 0.5;
constexpr double gap_at_edge = 0.3;
constexpr double tick_size = 0.45;

constexpr double half_root = 0.70710678118654752;

// Letters, not bytes: UTF-8 continues a letter with 10xxxxxx.
double letters(const std::string& text) {
  return static_cast<double>(std::ranges::count_if(text, [](char byte) { return (byte & 0xc0) != 0x80; }));
}

}  // namespace

std::string length_text(double length) {
  std::string text = fmt::format("{:.2f}", 1e3 * length);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

double width_of(const SketchText& text) {
  return letter_width * text.height * letters(text.text);
}

void Sketch::text(Layer layer, Point at, std::string text, Anchor anchor, double times_height) {
  texts_.push_back({.layer = layer,
                    .at = at,
                    .height = times_height * text_height_,
                    .anchor = anchor,
                    .upright = false,
                    .text = std::move(text)});
}

void Sketch::tick(Point at) {
  const double size = tick_size * text_height_;
  line(Layer::dimension, {at.x - size, at.y - size}, {at.x + size, at.y + size});
}

void Sketch::horizontal_dimension(double x1, double x2, double edge, double row) {
  const double out = row > edge ? 1.0 : -1.0;
  for (const double x : {x1, x2}) {
    line(Layer::dimension, {x, edge + out * gap_at_edge * text_height_}, {x, row + out * overhang * text_height_});
    tick({x, row});
  }
  line(Layer::dimension, {x1, row}, {x2, row});
  SketchText number{.layer = Layer::dimension,
                    .at = {0.5 * (x1 + x2), row + above_line * text_height_},
                    .height = text_height_,
                    .anchor = Anchor::middle,
                    .upright = false,
                    .text = length_text(std::abs(x2 - x1))};
  if (width_of(number) > std::abs(x2 - x1)) {
    number.at.x = std::max(x1, x2) + beside * text_height_;
    number.anchor = Anchor::start;
  }
  texts_.push_back(std::move(number));
}

void Sketch::vertical_dimension(double y1, double y2, double edge, double row) {
  const double out = row > edge ? 1.0 : -1.0;
  for (const double y : {y1, y2}) {
    line(Layer::dimension, {edge + out * gap_at_edge * text_height_, y}, {row + out * overhang * text_height_, y});
    tick({row, y});
  }
  line(Layer::dimension, {row, y1}, {row, y2});
  SketchText number{.layer = Layer::dimension,
                    .at = {row - above_line * text_height_, 0.5 * (y1 + y2)},
                    .height = text_height_,
                    .anchor = Anchor::middle,
                    .upright = true,
                    .text = length_text(std::abs(y2 - y1))};
  if (width_of(number) > std::abs(y2 - y1)) number.at.x -= line_spacing * text_height_;
  texts_.push_back(std::move(number));
}

void Sketch::diameter(Point centre, double radius, double row) {
  const Point on{centre.x + half_root * radius, centre.y + half_root * radius};
  line(Layer::dimension, on, {row, on.y});
  tick(on);
  text(Layer::dimension, {row + above_line * text_height_, on.y - 0.5 * text_height_}, "⌀" + length_text(2.0 * radius));
}

Bounds Sketch::bounds() const {
  constexpr double far = std::numeric_limits<double>::max();
  Bounds out{.low = {far, far}, .high = {-far, -far}};
  const auto take = [&](Point p) {
    out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y)};
    out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y)};
  };
  for (const SketchRectangle& each : rectangles_) take(each.low), take(each.high);
  for (const SketchLine& each : lines_) take(each.from), take(each.to);
  for (const SketchCircle& each : circles_) {
    take({each.centre.x - each.radius, each.centre.y - each.radius});
    take({each.centre.x + each.radius, each.centre.y + each.radius});
  }
  for (const SketchText& each : texts_) {
    const double share = each.anchor == Anchor::start ? 0.0 : each.anchor == Anchor::middle ? 0.5 : 1.0;
    const double before = share * width_of(each);
    const double after = width_of(each) - before;
    if (each.upright) {
      take({each.at.x - each.height, each.at.y - before});
      take({each.at.x, each.at.y + after});
    } else {
      take({each.at.x - before, each.at.y - 0.3 * each.height});
      take({each.at.x + after, each.at.y + each.height});
    }
  }
  return out;
}

}  // namespace coilwright::exports
