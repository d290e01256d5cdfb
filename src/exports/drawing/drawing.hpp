#pragma once

#include "coilwright/exports/body_plan.hpp"
#include "exports/drawing/sketch.hpp"

namespace coilwright::exports {

/// A sketch at the scale at which it is printed.
struct ScaledSketch {
  Sketch sketch;
  double scale{};  ///< paper over part
};

/// The drawing of a body on a sheet of `width` by `height`, m, at the largest scale of ISO 5455 that fits, with letters
/// of 2.5 mm. The smallest of its scales (1 to 100) where none fits.
[[nodiscard]] ScaledSketch drawing_on(const BodyPlan& plan, double width, double height);

/// "2:1", "1:5".
[[nodiscard]] std::string scale_text(double scale);

}  // namespace coilwright::exports
