#include "exports/drawing/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "coilwright/exports/kinds.hpp"

namespace coilwright::exports {
namespace {

using actuator::ComponentKind;

// Distances between rows of dimensions, in heights of a letter.
constexpr double first_row = 3.0;
constexpr double next_row = 4.0;

void coil_in_section(Sketch& sketch, const BodyPlan& plan, const PlacedPart& coil) {
  const double left = coil.centre - 0.5 * coil.length;
  const double right = coil.centre + 0.5 * coil.length;
  for (const double side : {-1.0, 1.0}) {
    const double inner = plan.axis_height + side * coil.inner_radius;
    const double outer = plan.axis_height + side * coil.radius;
    sketch.rectangle(Layer::winding, {left, std::min(inner, outer)}, {right, std::max(inner, outer)});
    sketch.line(Layer::winding, {left, inner}, {right, outer});
    sketch.line(Layer::winding, {left, outer}, {right, inner});
  }
}

void magnet_in_section(Sketch& sketch, const BodyPlan& plan, const PlacedPart& magnet) {
  const double half = 0.5 * magnet.length;
  sketch.rectangle(Layer::magnet, {magnet.centre - half, plan.axis_height - magnet.radius},
                   {magnet.centre + half, plan.axis_height + magnet.radius});
  const double height = std::min(0.4 * magnet.length, 0.5 * magnet.radius) / sketch.text_height();
  const double base = plan.axis_height + 0.2 * magnet.radius;
  const bool north_to_tip = magnet.component.polarity > 0;
  sketch.text(Layer::magnet, {magnet.centre - 0.5 * half, base}, north_to_tip ? "S" : "N", Anchor::middle,
              std::min(1.0, height));
  sketch.text(Layer::magnet, {magnet.centre + 0.5 * half, base}, north_to_tip ? "N" : "S", Anchor::middle,
              std::min(1.0, height));
}

void longitudinal_section(Sketch& sketch, const BodyPlan& plan) {
  const double unit = sketch.text_height();
  sketch.rectangle(Layer::body, {0.0, 0.0}, {plan.length, plan.height});
  sketch.line(Layer::body, {0.0, plan.bottom_layer}, {plan.length, plan.bottom_layer});
  int number = 0;
  for (const PlacedPart& part : plan.parts) {
    if (part.component.kind == ComponentKind::magnet)
      magnet_in_section(sketch, plan, part);
    else
      coil_in_section(sketch, plan, part);
    sketch.text(Layer::note, {part.centre, plan.axis_height - 1.7 * unit}, fmt::format("{}", ++number), Anchor::middle,
                std::min(1.0, 0.5 * part.length / unit));
  }
  for (const double joint : plan.joints) sketch.line(Layer::slit, {joint, plan.bottom_layer}, {joint, plan.height});
  sketch.line(Layer::axis, {-unit, plan.axis_height}, {plan.length + unit, plan.axis_height});
  sketch.line(Layer::axis, {-unit, plan.hinge_height}, {plan.length + unit, plan.hinge_height});
}

// Above: faces of the parts, then all. Below: the places of the slits, then what is between the parts, once where it is
// the same. Returns the height at which the lowest one ends.
double lengths(Sketch& sketch, const BodyPlan& plan) {
  const double unit = sketch.text_height();
  const auto front_face = [](const PlacedPart& part) { return part.centre + 0.5 * part.length; };
  const auto rear_face = [](const PlacedPart& part) { return part.centre - 0.5 * part.length; };
  std::vector<Span> faces{{0.0, rear_face(plan.parts.front())}};
  for (const PlacedPart& part : plan.parts) faces.push_back({rear_face(part), front_face(part)});
  faces.push_back({front_face(plan.parts.back()), plan.length});
  const double above = sketch.horizontal_dimensions(faces, plan.height, plan.height + first_row * unit);
  sketch.horizontal_dimension(0.0, plan.length, plan.height, above + 2.0 * unit);

  std::vector<Span> gaps;
  std::vector<Span> segments;
  std::set<std::string> shown;
  for (std::size_t joint = 0; joint < plan.joints.size(); ++joint) {
    const Span gap{front_face(plan.parts[joint]), rear_face(plan.parts[joint + 1])};
    if (shown.insert(length_text(gap.to - gap.from)).second) gaps.push_back(gap);
    segments.push_back({joint == 0 ? 0.0 : plan.joints[joint - 1], plan.joints[joint]});
  }
  segments.push_back({plan.joints.back(), plan.length});
  const double below = sketch.horizontal_dimensions(segments, 0.0, -first_row * unit);
  return sketch.horizontal_dimensions(gaps, 0.0, below - 2.5 * unit);
}

void heights(Sketch& sketch, const BodyPlan& plan) {
  const double unit = sketch.text_height();
  double row = -first_row * unit;
  sketch.vertical_dimension(0.0, plan.bottom_layer, 0.0, row);
  sketch.vertical_dimension(plan.bottom_layer, plan.height, 0.0, row);
  row = plan.length + first_row * unit;
  sketch.vertical_dimension(plan.hinge_height, plan.axis_height, plan.length, row);
  row += next_row * unit;
  sketch.vertical_dimension(0.0, plan.axis_height, plan.length, row);
  row += next_row * unit;
  sketch.vertical_dimension(0.0, plan.height, plan.length, row);
}

// With its lower left corner there; returns where, to the right, the next view may begin.
double cross_section(Sketch& sketch, const BodyPlan& plan, const PlacedPart& part, Point corner) {
  const double unit = sketch.text_height();
  const bool magnet = part.component.kind == ComponentKind::magnet;
  const Layer layer = magnet ? Layer::magnet : Layer::winding;
  const Point far{corner.x + plan.width, corner.y + plan.height};
  const Point centre{corner.x + 0.5 * plan.width, corner.y + plan.axis_height};
  sketch.rectangle(Layer::body, corner, far);
  sketch.line(Layer::body, {corner.x, corner.y + plan.bottom_layer}, {far.x, corner.y + plan.bottom_layer});
  sketch.circle(layer, centre, part.radius);
  if (!magnet) sketch.circle(layer, centre, part.inner_radius);
  sketch.line(Layer::axis, {corner.x - unit, centre.y}, {far.x + unit, centre.y});
  sketch.line(Layer::axis, {centre.x, corner.y - unit}, {centre.x, far.y + unit});
  const double beside = far.x + 2.0 * unit;
  sketch.diameter(centre, part.radius, beside);
  if (!magnet) sketch.diameter(centre, part.inner_radius, beside);
  sketch.horizontal_dimension(corner.x, far.x, corner.y, corner.y - first_row * unit);
  sketch.text(Layer::note, {centre.x, corner.y - (first_row + 2.0) * unit},
              magnet ? "through a magnet" : "through a coil", Anchor::middle);
  return beside + 12.0 * unit;
}

const PlacedPart& first_of(const BodyPlan& plan, ComponentKind kind) {
  return *std::ranges::find_if(plan.parts, [kind](const PlacedPart& part) { return part.component.kind == kind; });
}

constexpr std::array scales = {10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};  // ISO 5455
constexpr double letter_on_paper = 2.5e-3;

// A4 across, less its margins.
constexpr double sheet_width = 277e-3;
constexpr double sheet_height = 185e-3;

}  // namespace

Sketch sketch_of(const BodyPlan& plan, double text_height) {
  Sketch sketch(text_height);
  longitudinal_section(sketch, plan);
  heights(sketch, plan);
  const double below = lengths(sketch, plan) - 2.5 * text_height;
  sketch.text(Layer::note, {0.0, below}, "rear end");
  sketch.text(Layer::note, {plan.length, below}, "tip", Anchor::end);
  const double corner = below - 2.0 * text_height - plan.height;
  const double next = cross_section(sketch, plan, first_of(plan, ComponentKind::coil), {0.0, corner});
  static_cast<void>(cross_section(sketch, plan, first_of(plan, ComponentKind::magnet), {next, corner}));
  return sketch;
}

ScaledSketch drawing_on(const DesignSubject& subject, const BodyPlan& plan, double width, double height) {
  std::optional<ScaledSketch> smallest;
  for (const double scale : scales)
    for (const bool beside : {true, false}) {
      ScaledSketch out{
          .sketch = titled(sketch_of(plan, letter_on_paper / scale), title_block(subject, scale_text(scale)), beside),
          .scale = scale};
      const Bounds bounds = out.sketch.bounds();
      const double edges = 2.0 * letter_on_paper;
      if (scale * (bounds.high.x - bounds.low.x) + edges <= width &&
          scale * (bounds.high.y - bounds.low.y) + edges <= height)
        return out;
      smallest = std::move(out);
    }
  return *std::move(smallest);
}

std::string scale_text(double scale) {
  return scale >= 1.0 ? fmt::format("{:.4g}:1", scale) : fmt::format("1:{:.4g}", 1.0 / scale);
}

std::vector<ExportedFile> drawing(const DesignSubject& subject, const ExportSettings&) {
  const BodyPlan plan = body_plan(subject);
  const ScaledSketch scaled = drawing_on(subject, plan, sheet_width, sheet_height);
  const std::string title = subject.origin.name.empty() ? "Actuator" : subject.origin.name;
  const std::string scale = scale_text(scaled.scale);
  const std::string description = fmt::format("Longitudinal section and cross-sections, lengths in mm, scale {}. {}",
                                              scale, subject.origin.made_by);
  return {{.name = "drawing.svg", .text = svg_of(scaled.sketch, scaled.scale, {title, description})},
          {.name = "drawing.dxf",
           .text = dxf_of(titled(sketch_of(plan, scaled.sketch.text_height()), title_block(subject, ""), true))}};
}

}  // namespace coilwright::exports
