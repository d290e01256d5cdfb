#include "exports/drawing/drawing.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "coilwright/exports/drawing.hpp"
#include "exports/drawing/dxf.hpp"
#include "exports/drawing/svg.hpp"
#include "exports/drawing/views.hpp"

namespace coilwright::exports {
namespace {

constexpr std::array scales = {10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};  // ISO 5455
constexpr double letter_on_paper = 2.5e-3;

// A4 across, less its margins and a line for the title.
constexpr double sheet_width = 277e-3;
constexpr double sheet_height = 180e-3;

Sketch titled(Sketch sketch, std::string title) {
  const Point corner = sketch.bounds().low;
  sketch.text(Layer::note, {corner.x, corner.y - 2.0 * sketch.text_height()}, std::move(title));
  return sketch;
}

}  // namespace

ScaledSketch drawing_on(const BodyPlan& plan, double width, double height) {
  for (const double scale : scales) {
    ScaledSketch out{.sketch = sketch_of(plan, letter_on_paper / scale), .scale = scale};
    const Bounds bounds = out.sketch.bounds();
    const double edges = 2.0 * letter_on_paper;
    if (scale * (bounds.high.x - bounds.low.x) + edges <= width &&
        scale * (bounds.high.y - bounds.low.y) + edges <= height)
      return out;
  }
  return {.sketch = sketch_of(plan, letter_on_paper / scales.back()), .scale = scales.back()};
}

std::string scale_text(double scale) {
  return scale >= 1.0 ? fmt::format("{:.4g}:1", scale) : fmt::format("1:{:.4g}", 1.0 / scale);
}

std::vector<ExportedFile> drawing(const DesignSubject& subject, const ExportSettings&) {
  const ScaledSketch scaled = drawing_on(body_plan(subject), sheet_width, sheet_height);
  const std::string title = subject.origin.name.empty() ? "Actuator" : subject.origin.name;
  const std::string scale = scale_text(scaled.scale);
  const std::string description = fmt::format("Longitudinal section and cross-sections, lengths in mm, scale {}. {}",
                                              scale, subject.origin.made_by);
  return {{.name = "drawing.svg",
           .text = svg_of(titled(scaled.sketch, fmt::format("{}. Scale {}, lengths in mm.", title, scale)),
                          scaled.scale, {title, description})},
          {.name = "drawing.dxf", .text = dxf_of(titled(scaled.sketch, fmt::format("{}. Lengths in mm.", title)))}};
}

}  // namespace coilwright::exports
