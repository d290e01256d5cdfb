#include "coilwright/exports/body_plan.hpp"

#include <cstddef>

namespace coilwright::exports {

using actuator::ComponentKind;

BodyPlan body_plan(const DesignSubject& subject) {
  const actuator::Design& design = subject.design;
  const actuator::Dimensions& size = subject.assembly.dimensions;
  BodyPlan plan{.length = size.total_length,
                .width = size.width,
                .height = size.height,
                .axis_height = 0.5 * design.body.bottom_layer + size.axis_offset,
                .hinge_height = 0.5 * design.body.bottom_layer,
                .bottom_layer = design.body.bottom_layer,
                .parts = {},
                .joints = {}};
  double end = 0.0;  // of the last segment so far, at its joint
  for (std::size_t i = 0; i < design.layout.size(); ++i) {
    const bool magnet = design.layout[i].kind == ComponentKind::magnet;
    end += subject.assembly.segments[i].length;
    if (i + 1 < design.layout.size()) plan.joints.push_back(end);
    const double half_pitch = magnet ? size.magnet_half_pitch : size.coil_half_pitch;
    const double length = magnet ? design.magnet.length : size.coil_length;
    plan.parts.push_back({.component = design.layout[i],
                          .centre = end - half_pitch,
                          .half_pitch = half_pitch,
                          .length = length,
                          .radius = magnet ? design.magnet.radius : size.coil_outer_radius,
                          .inner_radius = magnet ? 0.0 : design.coil.inner_radius,
                          .face_wall = half_pitch - 0.5 * length});
  }
  return plan;
}

}  // namespace coilwright::exports
