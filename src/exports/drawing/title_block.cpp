#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "coilwright/actuator/number_widths.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "exports/drawing/sketch.hpp"

namespace coilwright::exports {
namespace {

// FNV-1a of 32 bits, of the text of the design's file without its name.
std::string number_of(const actuator::Design& design) {
  std::uint32_t hash = 2166136261U;
  for (const char each : formats::to_json(design, "").text()) {
    hash ^= static_cast<unsigned char>(each);
    hash *= 16777619U;
  }
  return fmt::format("CW-{:08X}", hash);
}

// Of the silicone between two parts, on which everything depends most.
std::string tolerance_text() {
  const auto gap = std::ranges::find(actuator::number_widths(), "gap_mm", &actuator::NumberWidth::name);
  return fmt::format("+-{:g} moulded, +-{:g} by hand", gap->printed, gap->by_hand);
}

std::string material_text(const actuator::Design& design) {
  std::string out = design.body.name();
  if (design.bottom_silicone) out += fmt::format(", bottom layer {}", design.bottom_silicone->name());
  return out;
}

// The largest x of what reaches further down than `y`.
double right_end_below(const Sketch& sketch, double y) {
  double out = sketch.bounds().low.x;
  const auto take = [&](double right, double low) {
    if (low < y) out = std::max(out, right);
  };
  for (const SketchRectangle& each : sketch.rectangles()) take(each.high.x, each.low.y);
  for (const SketchCircle& each : sketch.circles()) take(each.centre.x + each.radius, each.centre.y - each.radius);
  for (const SketchLine& each : sketch.lines())
    take(std::max(each.from.x, each.to.x), std::min(each.from.y, each.to.y));
  for (const SketchText& each : sketch.texts()) take(each.at.x + width_of(each), each.at.y);
  return out;
}

}  // namespace

std::vector<TitleField> title_block(const DesignSubject& subject, std::string scale) {
  const std::string name = subject.origin.name.empty() ? "Actuator" : subject.origin.name;
  std::vector<TitleField> out{{"Name", name},
                              {"Drawing number", number_of(subject.design)},
                              {"Material", material_text(subject.design)},
                              {"General tolerance", tolerance_text()},
                              {"Lengths", "mm"}};
  if (!scale.empty()) out.push_back({"Scale", std::move(scale)});
  out.push_back({"Date, signature", ""});
  return out;
}

Sketch titled(Sketch sketch, const std::vector<TitleField>& fields, bool beside) {
  const double unit = sketch.text_height();
  const double row_height = 2.2 * unit;
  const double label_width = 12.0 * unit;
  double value_width = 20.0 * unit;
  for (const TitleField& field : fields)
    value_width = std::max(value_width, width_of({Layer::note, {}, unit, Anchor::start, false, field.value}) + unit);
  const Bounds drawn = sketch.bounds();
  const double height = static_cast<double>(fields.size()) * row_height;
  const double top = drawn.low.y + (beside ? height : -2.0 * unit);
  const double left = beside ? right_end_below(sketch, top + unit) + 2.0 * unit : drawn.low.x;
  const double right = left + label_width + value_width;
  // As lines, which a DXF has on a layer of their own and a sheet draws thin.
  sketch.line(Layer::dimension, {left, top}, {right, top});
  for (const double x : {left, left + label_width, right}) sketch.line(Layer::dimension, {x, top}, {x, top - height});
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const double bottom = top - static_cast<double>(i + 1) * row_height;
    sketch.line(Layer::dimension, {left, bottom}, {right, bottom});
    sketch.text(Layer::note, {left + 0.5 * unit, bottom + 0.6 * unit}, std::string(fields[i].label), Anchor::start,
                0.8);
    sketch.text(Layer::note, {left + label_width + 0.5 * unit, bottom + 0.6 * unit}, fields[i].value);
  }
  return sketch;
}

}  // namespace coilwright::exports
