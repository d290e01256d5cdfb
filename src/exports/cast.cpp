#include "exports/cast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace coilwright::exports {
namespace {

constexpr double pi = std::numbers::pi;

double largest_radius(const BodyPlan& plan) {
  return std::ranges::max(plan.parts, {}, &PlacedPart::radius).radius;
}

// As much as the walls beside and below the widest part have, so that the pockets leave the bottom layer whole.
double clearance_of(const DesignSubject& subject, const BodyPlan& plan) {
  const double radius = largest_radius(plan);
  const double below = plan.axis_height - radius - plan.bottom_layer;
  const double above = plan.height - plan.axis_height - radius;
  if (!(below > 0.0))
    throw std::invalid_argument(
        fmt::format("the measured axis lies {:.4g} mm above the underside, where the largest part (radius {:.4g} mm) "
                    "cuts into the bottom layer ({:.4g} mm): it cannot be cast so",
                    plan.axis_height * 1e3, radius * 1e3, plan.bottom_layer * 1e3));
  if (!(above > 0.0))
    throw std::invalid_argument(
        fmt::format("the measured axis lies {:.4g} mm above the underside, where the largest part (radius {:.4g} mm) "
                    "stands out of a body {:.4g} mm high: it cannot be cast so",
                    plan.axis_height * 1e3, radius * 1e3, plan.height * 1e3));
  return std::min(below, 0.5 * subject.design.body.side_wall);
}

double largest_dip(const BodyPlan& plan) {
  double largest = 0.0;
  for (const PlacedPart& part : plan.parts) {
    const double cup_radius = part.radius + dip_room;
    const double own = part.radius * part.radius * part.length;
    largest = std::max(largest, pi * (cup_radius * cup_radius * (part.length + 2.0 * dip_room) - own));
  }
  return largest;
}

}  // namespace

double volume_of(const actuator::Segment& segment, const actuator::Design& design) {
  const double bottom = design.bottom_silicone ? segment.bottom_mass / design.bottom_silicone->density : 0.0;
  return (segment.silicone_mass - segment.bottom_mass) / design.body.density + bottom;
}

double section_of(const Pocket& pocket, const BodyPlan& plan) {
  return 0.5 * pi * pocket.radius * pocket.radius + 2.0 * pocket.radius * (plan.height - plan.axis_height);
}

Cast cast_of(const DesignSubject& subject) {
  Cast cast;
  cast.plan = body_plan(subject);
  cast.clearance = clearance_of(subject, cast.plan);
  double in_pockets = 0.0;
  for (const PlacedPart& part : cast.plan.parts) {
    cast.pockets.push_back({.start = part.centre - part.half_pitch,
                            .length = 2.0 * part.half_pitch,
                            .radius = part.radius + cast.clearance});
    in_pockets += section_of(cast.pockets.back(), cast.plan) * cast.pockets.back().length;
  }
  for (const actuator::Segment& segment : subject.assembly.segments) {
    cast.silicone_volume += volume_of(segment, subject.design);
    if (subject.design.bottom_silicone)
      cast.bottom_volume += segment.bottom_mass / subject.design.bottom_silicone->density;
  }
  cast.main_volume = cast.plan.length * cast.plan.width * cast.plan.height - in_pockets;
  cast.filling_volume = cast.silicone_volume - cast.main_volume;
  cast.main_volume -= cast.bottom_volume;
  cast.dip_volume = largest_dip(cast.plan);
  return cast;
}

}  // namespace coilwright::exports
