#include "coilwright/actuator/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "actuator/heat_chain.hpp"
#include "coilwright/winding/copper.hpp"

namespace coilwright::actuator {
namespace {

double core_radius(const Design& design, const Dimensions& size, ComponentKind kind) {
  return kind == ComponentKind::magnet ? design.magnet.radius : size.coil_outer_radius;
}

void check_angles(const Assembly& assembly, const mechanics::JointVector& angles) {
  const int joints = assembly.model.joints();
  if (angles.size() != joints)
    throw std::invalid_argument(fmt::format("joint_angles: must have {} values; got {}", joints, angles.size()));
  for (int j = 0; j < joints; ++j)
    if (!std::isfinite(angles[j]))
      throw std::invalid_argument(fmt::format("joint_angles[{}]: must be finite; got {}", j, angles[j]));
}

}  // namespace

mechanics::JointVector joints_at(const Assembly& assembly, double joint_angle) {
  return mechanics::JointVector::Constant(assembly.model.joints(), joint_angle);
}

thermal::HeatChain heat_chain(const Design& design, const Assembly& assembly,
                              const mechanics::JointVector& joint_angles) {
  check_angles(assembly, joint_angles);
  const Dimensions& size = assembly.dimensions;
  thermal::HeatChain chain;
  chain.width = size.width;
  chain.height = size.height;
  chain.heat_transfer = design.surroundings.heat_transfer * design.calibration.heat_transfer;
  chain.silicone_conductivity = design.body.conductivity;
  chain.ambient = design.surroundings.ambient;
  chain.temperature_coefficient = winding::copper_temperature_coefficient;
  const int count = static_cast<int>(design.layout.size());
  for (int i = 0; i < count; ++i) {
    const ComponentKind kind = design.layout[i].kind;
    const bool magnet = kind == ComponentKind::magnet;
    chain.segments.push_back(
        {.kind = magnet ? thermal::NodeKind::magnet : thermal::NodeKind::coil,
         .length = 2.0 * (magnet ? size.magnet_half_pitch : size.coil_half_pitch),
         .core_radius = core_radius(design, size, kind),
         .solid_end = i == 0 ? design.body.rear_length : (i + 1 == count ? design.body.front_length : 0.0),
         .resistance = magnet ? 0.0 : assembly.coil.resistance,
         .heat_capacity = assembly.segments[i].heat_capacity,
         .temperature_limit = magnet ? design.magnet.temperature_limit : design.surroundings.coil_limit});
    if (i == 0) continue;
    const double narrower =
        std::min(core_radius(design, size, kind), core_radius(design, size, design.layout[i - 1].kind));
    chain.gaps.push_back({.silicone = design.body.gap,
                          .air = thermal::equivalent_air_gap({.angle = std::max(0.0, joint_angles[i - 1]),
                                                              .hinge_distance = size.axis_offset,
                                                              .core_radius = narrower})});
  }
  return chain;
}

thermal::Network heat_network(const Design& design, const Assembly& assembly, double joint_angle) {
  return heat_network(design, assembly, joints_at(assembly, joint_angle));
}

thermal::Network heat_network(const Design& design, const Assembly& assembly,
                              const mechanics::JointVector& joint_angles) {
  return thermal::build_network(heat_chain(design, assembly, joint_angles));
}

}  // namespace coilwright::actuator
