#include "exports/drawing/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace coilwright::exports {
namespace {

// In heights of a capital letter.
constexpr double letter_width = 0.8;
constexpr double above_line = 0.35;
constexpr double line_spacing = 1.4;
constexpr double number_padding = 0.4;
constexpr double overhang = 0.5;
constexpr double gap_at_edge = 0.3;
constexpr double tick_size = 0.45;

constexpr double half_root = 0.70710678118654752;

// Letters, not bytes: UTF-8 continues a letter with 10xxxxxx.
double letters(const std::string& text) {
  return static_cast<double>(std::ranges::count_if(text, [](char byte) { return (byte & 0xc0) != 0x80; }));
}

// Which places a row of numbers takes, on levels above each other; 0 is that of the numbers within their line.
class Levels {
 public:
  explicit Levels(double padding) : padding_(padding) {}

  void take(int level, const SketchText& text) {
    if (static_cast<std::size_t>(level) >= taken_.size()) taken_.resize(static_cast<std::size_t>(level) + 1);
    taken_[static_cast<std::size_t>(level)].push_back(place_of(text));
  }
  // From 1 on: a number beside its line.
  [[nodiscard]] int first_free(const SketchText& text) const {
    std::size_t level = 1;
    while (level < taken_.size() && overlaps(level, place_of(text))) ++level;
    return static_cast<int>(level);
  }

 private:
  [[nodiscard]] Span place_of(const SketchText& text) const {
    const double half = 0.5 * (width_of(text) + padding_);
    return {text.at.x - half, text.at.x + half};
  }
  [[nodiscard]] bool overlaps(std::size_t level, const Span& place) const {
    return std::ranges::any_of(taken_[level],
                               [&](const Span& other) { return other.from < place.to && place.from < other.to; });
  }

  double padding_;
  std::vector<std::vector<Span>> taken_;
};

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
  const Span span{x1, x2};
  horizontal_dimensions({&span, 1}, edge, row);
}

double Sketch::horizontal_dimensions(std::span<const Span> spans, double edge, double row) {
  const double out = row > edge ? 1.0 : -1.0;
  Levels levels(number_padding * text_height_);
  std::vector<SketchText> narrow;
  for (const Span& span : spans) {
    for (const double x : {span.from, span.to}) {
      line(Layer::dimension, {x, edge + out * gap_at_edge * text_height_}, {x, row + out * overhang * text_height_});
      tick({x, row});
    }
    line(Layer::dimension, {span.from, row}, {span.to, row});
    SketchText number{.layer = Layer::dimension,
                      .at = {0.5 * (span.from + span.to), row + above_line * text_height_},
                      .height = text_height_,
                      .anchor = Anchor::middle,
                      .upright = false,
                      .text = length_text(span.to - span.from)};
    if (width_of(number) > span.to - span.from) {
      narrow.push_back(std::move(number));
    } else {
      levels.take(0, number);
      texts_.push_back(std::move(number));
    }
  }
  double end = row + (out > 0.0 ? (above_line + 1.0) * text_height_ : 0.0);
  for (SketchText& number : narrow) {
    const int level = levels.first_free(number);
    levels.take(level, number);
    const double first = out > 0.0 ? above_line + line_spacing : overhang + above_line;
    const double distance = (first + (level - 1) * line_spacing) * text_height_;
    number.at.y = row + (out > 0.0 ? distance : -distance - text_height_);
    line(Layer::dimension, {number.at.x, row}, {number.at.x, row + out * (distance - 0.5 * above_line * text_height_)});
    const double outer = out > 0.0 ? number.at.y + text_height_ : number.at.y;
    end = out > 0.0 ? std::max(end, outer) : std::min(end, outer);
    texts_.push_back(std::move(number));
  }
  return end;
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
  for (const SketchFill& each : fills_)
    for (const Bounds& area : each.areas) take(area.low), take(area.high);
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
