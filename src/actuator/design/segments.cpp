#include "coilwright/actuator/design/segments.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "actuator/design/specific_heats.hpp"

namespace coilwright::actuator {
namespace {

// A homogeneous body whose inertia is about its own centre of mass.
struct Body {
  double mass{};
  double along{};
  double offset{};
  double inertia{};
};

// Parallel axes: adding a body shifts both inertias to the common centre of mass. A negative mass takes a hole out.
Body operator+(const Body& a, const Body& b) {
  Body sum;
  sum.mass = a.mass + b.mass;
  sum.along = (a.mass * a.along + b.mass * b.along) / sum.mass;
  sum.offset = (a.mass * a.offset + b.mass * b.offset) / sum.mass;
  const auto shifted = [&](const Body& part) {
    const double dx = part.along - sum.along;
    const double dy = part.offset - sum.offset;
    return part.inertia + part.mass * (dx * dx + dy * dy);
  };
  sum.inertia = shifted(a) + shifted(b);
  return sum;
}

struct Ring {
  double inner_radius{};
  double outer_radius{};
  double length{};

  [[nodiscard]] double volume() const {
    return std::numbers::pi * (outer_radius * outer_radius - inner_radius * inner_radius) * length;
  }
  // About a diameter through the middle.
  [[nodiscard]] double inertia(double mass) const {
    return mass * (3.0 * (outer_radius * outer_radius + inner_radius * inner_radius) + length * length) / 12.0;
  }
};

// What is the same for every segment of one design.
struct Materials {
  const Design& design;
  const Dimensions& size;
  double copper_mass;
  double filler_mass = 0.0;  // of what is cast between the turns of one coil

  [[nodiscard]] Body box(double start, double length) const {
    const double mass = design.body.density * size.width * size.height * length;
    return {.mass = mass,
            .along = start + 0.5 * length,
            .offset = 0.5 * (size.height - design.body.bottom_layer),
            .inertia = mass * (size.height * size.height + length * length) / 12.0};
  }

  // What the bottom layer has more than the body's silicone in its place; its middle is the hinge line.
  [[nodiscard]] Body bottom_excess(double length) const {
    const double thickness = design.body.bottom_layer;
    const double mass = (design.bottom_silicone->density - design.body.density) * size.width * thickness * length;
    return {.mass = mass,
            .along = 0.5 * length,
            .offset = 0.0,
            .inertia = mass * (thickness * thickness + length * length) / 12.0};
  }

  [[nodiscard]] Ring core(ComponentKind kind) const {
    if (kind == ComponentKind::magnet)
      return {.inner_radius = 0.0, .outer_radius = design.magnet.radius, .length = design.magnet.length};
    return {
        .inner_radius = design.coil.inner_radius, .outer_radius = size.coil_outer_radius, .length = size.coil_length};
  }

  [[nodiscard]] double core_mass(ComponentKind kind) const {
    return kind == ComponentKind::magnet ? design.magnet.density * core(kind).volume() : copper_mass + filler_mass;
  }

  [[nodiscard]] double core_heat(ComponentKind kind) const {
    return kind == ComponentKind::magnet ? core_mass(kind) * magnet_specific_heat
                                         : copper_mass * copper_specific_heat + filler_mass * design.body.heat_capacity;
  }

  [[nodiscard]] Body core_body(ComponentKind kind, double mass, double centre) const {
    return {.mass = mass, .along = centre, .offset = size.axis_offset, .inertia = core(kind).inertia(mass)};
  }
};

// Of the silicone between enamelled turns; their enamel weighs nothing, as elsewhere.
double filler_mass(const Materials& materials) {
  if (materials.design.coil.filler != Filler::silicone) return 0.0;
  const Ring ring = materials.core(ComponentKind::coil);
  const double mean_turn = std::numbers::pi * (ring.inner_radius + ring.outer_radius);
  const double wires = wires_section(materials.design.coil) * mean_turn;
  return materials.design.body.density * std::max(0.0, ring.volume() - wires);
}

// The segment from `start` (negative for a rear part) to its joint-side end plus `front`, its core at half_pitch.
struct Extent {
  ComponentKind kind{};
  double half_pitch{};
  double rear{};
  double front{};
};

Segment segment(const Materials& materials, const Extent& extent) {
  const Ring core = materials.core(extent.kind);
  const double core_mass = materials.core_mass(extent.kind);
  const double centre = extent.rear + extent.half_pitch;
  const double length = extent.rear + 2.0 * extent.half_pitch + extent.front;
  const Body hole = materials.core_body(extent.kind, -materials.design.body.density * core.volume(), centre);
  Body silicone = materials.box(0.0, length) + hole;
  double silicone_heat = silicone.mass * materials.design.body.heat_capacity;
  double bottom_mass = 0.0;
  if (const std::optional<SiliconeDesign>& bottom = materials.design.bottom_silicone) {
    bottom_mass = bottom->density * materials.size.width * materials.design.body.bottom_layer * length;
    silicone = silicone + materials.bottom_excess(length);
    silicone_heat =
        (silicone.mass - bottom_mass) * materials.design.body.heat_capacity + bottom_mass * bottom->heat_capacity;
  }
  const Body whole = silicone + materials.core_body(extent.kind, core_mass, centre);

  const Calibration& calibration = materials.design.calibration;
  const bool magnet = extent.kind == ComponentKind::magnet;
  const double factor = magnet ? calibration.magnet_segment_mass : calibration.coil_segment_mass;
  const bool points = materials.design.choices.masses == SegmentMass::on_axis_points;
  Segment out;
  out.length = length - extent.front;
  out.mass = factor * whole.mass;
  out.com_along = (extent.front > 0.0 ? calibration.tip_com : 1.0) * whole.along;
  out.com_offset = points ? materials.size.axis_offset : whole.offset;
  out.inertia = points ? 0.0 : factor * whole.inertia;
  out.silicone_mass = silicone.mass;
  out.bottom_mass = bottom_mass;
  out.heat_capacity = silicone_heat + materials.core_heat(extent.kind);
  return out;
}

}  // namespace

std::vector<Segment> segments(const Design& design, const Dimensions& dimensions) {
  Materials materials{design, dimensions, winding_of(design).copper_mass()};
  materials.filler_mass = filler_mass(materials);
  std::vector<Segment> out;
  out.reserve(design.layout.size());
  for (std::size_t i = 0; i < design.layout.size(); ++i) {
    const ComponentKind kind = design.layout[i].kind;
    const bool last = i + 1 == design.layout.size();
    out.push_back(segment(materials, {.kind = kind,
                                      .half_pitch = kind == ComponentKind::magnet ? dimensions.magnet_half_pitch
                                                                                  : dimensions.coil_half_pitch,
                                      .rear = i == 0 ? design.body.rear_length : 0.0,
                                      .front = last ? design.body.front_length : 0.0}));
  }
  return out;
}

}  // namespace coilwright::actuator
