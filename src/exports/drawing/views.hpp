#pragma once

#include "coilwright/exports/body_plan.hpp"
#include "exports/drawing/sketch.hpp"

namespace coilwright::exports {

/// The actuator straight: longitudinal section, and cross-sections through its first coil and its first magnet, all
/// with dimensions in mm. The rear end of the underside is at (0, 0). `text_height`: m in the world of the actuator.
[[nodiscard]] Sketch sketch_of(const BodyPlan& plan, double text_height);

}  // namespace coilwright::exports
