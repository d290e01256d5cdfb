#include "coilwright/actuator/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "actuator/design/specific_heats.hpp"
#include "actuator/heat_chain.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/thermal/paths.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "coilwright/winding/copper.hpp"

namespace coilwright::actuator {
namespace {

// Magnets, W/(m K): sintered NdFeB, makers' tables. Hardly a resistance beside silicone.
constexpr double magnet_conductivity = 9.0;
// Air at 100 degC, W/(m K): VDI Heat Atlas, dry air at 1 bar.
constexpr double air_conductivity = 0.0314;
// Wires that touch conduct no better in the bound for cylinders apart; beyond this share it leaves its range.
constexpr double most_copper = 0.9;

double cylinder(double radius, double length) {
  return std::numbers::pi * radius * radius * length;
}

thermal::HeatSegment magnet_part(const Design& design, const Dimensions& size) {
  const MagnetDesign& magnet = design.magnet;
  return {.kind = thermal::NodeKind::magnet,
          .core_length = magnet.length,
          .core_radius = magnet.radius,
          .core_conductivity = magnet_conductivity,
          .core_heat_capacity = magnet_specific_heat * magnet.density * cylinder(magnet.radius, magnet.length),
          .wall = size.magnet_half_pitch - 0.5 * magnet.length,
          .temperature_limit = magnet.temperature_limit};
}

// Across the turns of a coil, W/(m K). Enamel conducts as silicone does; beside air it counts as conductor, since a
// coated wire conducts 50 times as well as what is around it.
double across_turns(const Design& design, double copper_share, double area) {
  if (design.coil.filler != Filler::air) return thermal::across_wires(copper_share, design.body.conductivity);
  return thermal::across_wires(std::min(most_copper, wires_section(design.coil) / area), air_conductivity);
}

// In the bore is silicone, and between the wires too, or what conducts and stores as it does, unless it is air.
thermal::HeatSegment coil_part(const Design& design, const Assembly& assembly) {
  const Dimensions& size = assembly.dimensions;
  const double bore = design.coil.inner_radius;
  const double whole = cylinder(size.coil_outer_radius, size.coil_length);
  const double ring = whole - cylinder(bore, size.coil_length);
  const double area = (size.coil_outer_radius - bore) * size.coil_length;
  const double wires = design.coil.turns_radial * design.coil.turns_axial * wire_of(design.coil).copper_section();
  const double copper_share = std::min(most_copper, wires / area);
  const double share_without_silicone = design.coil.filler == Filler::air ? 1.0 : copper_share;
  const double filler = design.body.density * design.body.heat_capacity * (whole - share_without_silicone * ring);
  return {.kind = thermal::NodeKind::coil,
          .core_length = size.coil_length,
          .core_radius = size.coil_outer_radius,
          .bore_radius = bore,
          .core_conductivity = across_turns(design, copper_share, area),
          .core_heat_capacity = copper_specific_heat * assembly.coil.copper_mass + filler,
          .wall = size.coil_half_pitch - 0.5 * size.coil_length,
          .resistance = assembly.coil.resistance,
          .temperature_limit = design.surroundings.coil_limit};
}

void check_angles(const Assembly& assembly, const mechanics::JointVector& angles) {
  const int joints = assembly.model.joints();
  if (angles.size() != joints)
    throw std::invalid_argument(fmt::format("joint_angles: must have {} values; got {}", joints, angles.size()));
  for (int j = 0; j < joints; ++j)
    if (!std::isfinite(angles[j]))
      throw std::invalid_argument(fmt::format("joint_angles[{}]: must be finite; got {}", j, angles[j]));
}

// Mean surface temperature of the chain while the first part is at its limit in the film of a surface that is `assumed`
// degC warm; never above `most`.
double surface_at_limit(thermal::HeatChain& chain, double assumed, double most) {
  chain.heat_transfer =
      thermal::still_air_film({.height = chain.height, .ambient = chain.ambient, .surface_temperature = assumed});
  const thermal::Network network = thermal::build_network(chain);
  const double current = thermal::current_limits(network).for_good();
  const thermal::SteadyState held =
      thermal::steady_state(network, thermal::same_in_every_coil(network, current * current));
  if (held.outcome == thermal::Outcome::runaway) return most;
  return std::clamp(thermal::mean_surface_temperature(chain, held.temperatures), chain.ambient, most);
}

// A warmer surface has the better film and so is cooler: the temperature that both agree on lies between ambient and
// the coils' limit, and secants find it.
thermal::HeatChain in_still_air(thermal::HeatChain chain, const Design& design) {
  constexpr double same = 1e-6;  // K: 1e-8 of the film
  constexpr int most_rounds = 30;
  const double most = std::max(chain.ambient, design.surroundings.coil_limit);
  double before = 0.5 * (chain.ambient + most);
  double fault_before = surface_at_limit(chain, before, most) - before;
  double surface = before + fault_before;
  for (int round = 0; round < most_rounds; ++round) {
    const double fault = surface_at_limit(chain, surface, most) - surface;
    if (std::abs(fault) < same || fault == fault_before) break;
    const double next = surface - fault * (surface - before) / (fault - fault_before);
    before = std::exchange(surface, std::clamp(next, chain.ambient, most));
    fault_before = fault;
  }
  return chain;
}

thermal::HeatChain chain_in_its_film(const Design& design, const Assembly& assembly,
                                     const mechanics::JointVector& joint_angles) {
  thermal::HeatChain chain = heat_chain(design, assembly, joint_angles);
  return design.choices.film == FilmChoice::still_air ? in_still_air(std::move(chain), design) : chain;
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
  chain.heat_transfer = calibrated_film(design);
  chain.silicone_conductivity = design.body.conductivity;
  chain.ambient = design.surroundings.ambient;
  chain.temperature_coefficient = winding::copper_temperature_coefficient;
  chain.hinge_layer = design.body.bottom_layer;
  // Where the parts lie: a calibrated axis is that of the hinge torque.
  chain.axis_offset = size.body_radius + design.body.bottom_wall + 0.5 * design.body.bottom_layer;
  chain.silicone_heat_capacity = design.body.density * design.body.heat_capacity;
  if (const std::optional<SiliconeDesign>& bottom = design.bottom_silicone)
    chain.bottom = thermal::BottomLayer{.conductivity = bottom->conductivity,
                                        .heat_capacity = bottom->density * bottom->heat_capacity};
  const std::size_t count = design.layout.size();
  const std::vector<double> shares = current_shares(design);
  std::size_t coil = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool magnet = design.layout[i].kind == ComponentKind::magnet;
    thermal::HeatSegment segment = magnet ? magnet_part(design, size) : coil_part(design, assembly);
    if (!magnet) segment.current_share = shares[coil++];
    segment.solid_end = i == 0 ? design.body.rear_length : (i + 1 == count ? design.body.front_length : 0.0);
    chain.segments.push_back(segment);
    if (i > 0)
      chain.joint_angles.push_back(std::clamp(joint_angles[static_cast<Eigen::Index>(i) - 1], 0.0, std::numbers::pi));
  }
  return chain;
}

thermal::Network heat_network(const Design& design, const Assembly& assembly, double joint_angle) {
  return heat_network(design, assembly, joints_at(assembly, joint_angle));
}

thermal::Network heat_network(const Design& design, const Assembly& assembly,
                              const mechanics::JointVector& joint_angles) {
  return thermal::build_network(chain_in_its_film(design, assembly, joint_angles));
}

double skin_temperature(const Design& design, const Assembly& assembly, const mechanics::JointVector& joint_angles,
                        const thermal::NodeVector& temperatures) {
  return thermal::skin_temperature(chain_in_its_film(design, assembly, joint_angles), temperatures);
}

double calibrated_film(const Design& design) {
  return design.surroundings.heat_transfer * design.calibration.heat_transfer;
}

double still_air_film(const Design& design, const Assembly& assembly, const mechanics::JointVector& joint_angles) {
  return in_still_air(heat_chain(design, assembly, joint_angles), design).heat_transfer;
}

thermal::Network still_air_network(const Design& design, const Assembly& assembly,
                                   const mechanics::JointVector& joint_angles) {
  return thermal::build_network(in_still_air(heat_chain(design, assembly, joint_angles), design));
}

}  // namespace coilwright::actuator
