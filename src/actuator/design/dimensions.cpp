#include "coilwright/actuator/design/dimensions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/design/value_limits.hpp"
#include "coilwright/winding/packing.hpp"
#include "coilwright/winding/wire.hpp"

namespace coilwright::actuator {
namespace {

// Of the gap's two silicone walls, one third is the coil's and two thirds the magnet's: 0.3 and 0.6 mm of the
// prototype's 0.9 (Tables I and II: l_0 - l_c / 2 and l_1 - l_m / 2).
constexpr double coil_wall_share = 1.0 / 3.0;

// Layers or turns in a layer (of the thinnest wire in the table they make a metre): beyond them a slip of the keyboard
// is likelier than a finger.
constexpr int most_turns = 10'000;

// Of a silicone, Pa: gels to the hardest rubbers.
constexpr double softest_silicone = 1e3;
constexpr double stiffest_silicone = 1e8;

class MisfitList {
 public:
  void require_positive(double value, const char* name, double unit, const char* unit_name) {
    if (std::isfinite(value) && value > 0.0) return;
    const double excess = std::isfinite(value) ? 1.0 - value / unit : 1.0;
    list_.push_back({fmt::format("{} must be finite and > 0; got {:.6g} {}", name, value / unit, unit_name), excess});
  }
  void require_length(double value, const char* name) {
    if (value >= shortest_length && value <= longest_length) return;
    const double outside = value > longest_length ? value / longest_length - 1.0 : 1.0 - value / 1e-3;
    list_.push_back({fmt::format("{} must be from {:.6g} to {:.6g} mm; got {:.6g} mm", name, shortest_length * 1e3,
                                 longest_length * 1e3, value * 1e3),
                     std::isfinite(outside) ? outside : 1.0});
  }
  void require_not_negative(double value, const char* name, double unit, const char* unit_name) {
    if (std::isfinite(value) && value >= 0.0) return;
    const double excess = std::isfinite(value) ? 1.0 - value / unit : 1.0;
    list_.push_back({fmt::format("{} must be finite and >= 0; got {:.6g}{}", name, value / unit, unit_name), excess});
  }
  void require_finite(double value, const char* name, const char* unit_name) {
    if (!std::isfinite(value))
      list_.push_back({fmt::format("{} must be finite; got {} {}", name, value, unit_name), 1.0});
  }
  void require_factor(double value, const char* name) {
    if (std::isfinite(value) && value > 0.0) return;
    list_.push_back({fmt::format("calibration factor of {} must be finite and > 0; got {}", name, value), 1.0});
  }
  void require_turns(int value, const char* name) {
    if (value < 1) list_.push_back({fmt::format("{} must be at least 1; got {}", name, value), 1.0 - value});
    if (value > most_turns)
      list_.push_back({fmt::format("{} must be at most {}; got {}", name, most_turns, value),
                       static_cast<double>(value) / most_turns - 1.0});
  }
  void require_within(double value, double lowest, double highest, const std::string& name) {
    if (!(value >= lowest && value <= highest))
      list_.push_back({fmt::format("{} must lie in {:.6g} to {:.6g}; got {}", name, lowest, highest, value), 1.0});
  }
  void add(std::string rule, double excess) { list_.push_back({std::move(rule), excess}); }
  [[nodiscard]] ConstructionFaults take() { return std::move(list_); }
  [[nodiscard]] bool empty() const { return list_.empty(); }

 private:
  ConstructionFaults list_;
};

void check_material(const MagnetDesign& magnet, MisfitList& list) {
  if (magnet.coercivity != 0.0)
    list.require_within(1e-3 * magnet.coercivity, 1e-3 * least_coercivity, 1e-3 * most_coercivity,
                        "coercivity in kA/m");
  list.require_within(1e2 * magnet.remanence_coefficient, -1e2 * most_coefficient, 1e2 * most_coefficient,
                      "remanence coefficient in %/K");
  list.require_within(1e2 * magnet.coercivity_coefficient, -1e2 * most_coefficient, 1e2 * most_coefficient,
                      "coercivity coefficient in %/K");
  list.require_within(magnet.recoil_permeability, 1.0, magnetics::CylinderMagnet::most_recoil_permeability,
                      "recoil permeability");
  list.require_within(magnet.squareness, least_squareness, most_squareness, "squareness");
}

void check_sizes(const Design& design, MisfitList& list) {
  list.require_length(design.coil.inner_radius, "coil inner radius");
  list.require_turns(design.coil.turns_radial, "turns_radial");
  list.require_turns(design.coil.turns_axial, "turns_axial");
  list.require_length(design.magnet.radius, "magnet radius");
  list.require_length(design.magnet.length, "magnet length");
  list.require_positive(design.magnet.remanence, "remanence", 1.0, "T");
  if (design.magnet.remanence > most_remanence && std::isfinite(design.magnet.remanence))
    list.add(fmt::format("remanence must be at most {} T, which no magnet reaches; got {:.6g} T", most_remanence,
                         design.magnet.remanence),
             design.magnet.remanence / most_remanence - 1.0);
  list.require_positive(design.magnet.density, "magnet density", 1.0, "kg/m3");
  check_material(design.magnet, list);
  const BodyDesign& body = design.body;
  list.require_length(body.gap, "gap");
  list.require_length(body.bottom_layer, "bottom layer");
  list.require_length(body.side_wall, "side wall");
  list.require_length(body.bottom_wall, "bottom wall");
  list.require_length(body.top_wall, "top wall");
  list.require_length(body.front_length, "front length");
  list.require_length(body.rear_length, "rear length");
  list.require_length(body.hinge_length, "hinge length");
  list.require_not_negative(body.slot_width, "slot width", 1e-3, " mm");
  list.require_within(body.poisson_ratio, 0.0, 0.5, "Poisson's ratio");
  list.require_not_negative(body.loss_factor, "loss factor", 1.0, "");
  list.require_not_negative(body.loss_time, "loss time", 1e-3, " ms");
  list.require_not_negative(body.constant_damping, "constant damping", 1e-3, " N mm s/rad");
}

// Of the body, or `of` the bottom layer.
void check_silicone(const SiliconeDesign& silicone, const std::string& of, MisfitList& list) {
  list.require_positive(silicone.density, (of + "silicone density").c_str(), 1.0, "kg/m3");
  list.require_positive(silicone.heat_capacity, (of + "silicone heat capacity").c_str(), 1.0, "J/(kg K)");
  list.require_positive(silicone.conductivity, (of + "silicone conductivity").c_str(), 1.0, "W/(m K)");
  constexpr double megapascal = 1e6;
  if (silicone.young_modulus != 0.0)
    list.require_within(silicone.young_modulus / megapascal, softest_silicone / megapascal,
                        stiffest_silicone / megapascal, of + "Young's modulus in MPa");
  else if (silicone.shore_hardness_00 != 0.0)
    list.require_within(silicone.shore_hardness_00, 10.0, 70.0, of + "shore 00 hardness");
  else
    list.require_within(silicone.shore_hardness, 20.0, 80.0, of + "shore hardness");
}

void check_surroundings(const Design& design, MisfitList& list) {
  const Surroundings& around = design.surroundings;
  if (!(around.gravity >= 0.0 && around.gravity <= most_gravity))
    list.add(fmt::format("gravity must lie in 0 to {} m/s2; got {}", most_gravity, around.gravity), 1.0);
  list.require_finite(around.base_tilt, "base tilt", "rad");
  list.require_finite(around.coil_limit, "coil temperature limit", "degC");
  list.require_finite(design.magnet.temperature_limit, "magnet temperature limit", "degC");
  list.require_positive(around.heat_transfer, "heat transfer", 1.0, "W/(m2 K)");
  if (!(around.ambient >= coldest_ambient && around.ambient <= hottest_ambient))
    list.add(fmt::format("ambient must lie in {} to {} degC; got {}", coldest_ambient, hottest_ambient, around.ambient),
             1.0);
}

void check_calibration(const Calibration& factors, MisfitList& list) {
  list.require_factor(factors.axial_pitch, "axial pitch");
  list.require_factor(factors.radial_pitch, "radial pitch");
  list.require_factor(factors.joint_stiffness, "joint stiffness");
  list.require_factor(factors.joint_damping, "joint damping");
  list.require_not_negative(factors.constant_damping, "calibration factor of constant damping", 1.0, "");
  list.require_factor(factors.axis_offset, "axis offset");
  list.require_factor(factors.magnet_segment_mass, "magnet segment mass");
  list.require_factor(factors.coil_segment_mass, "coil segment mass");
  list.require_factor(factors.tip_com, "tip centre of mass");
  list.require_factor(factors.coil_resistance, "coil resistance");
  list.require_factor(factors.heat_transfer, "heat transfer");
}

void check_wire(const Design& design, MisfitList& list) {
  const CoilDesign& coil = design.coil;
  const int awg = coil.wire_gauge;
  if (coil.wire_diameter == 0.0 && (awg < winding::thickest_gauge || awg > winding::thinnest_gauge)) {
    const int outside = std::max(winding::thickest_gauge - awg, awg - winding::thinnest_gauge);
    list.add(
        fmt::format("wire gauge must be AWG {} to {}; got {}", winding::thickest_gauge, winding::thinnest_gauge, awg),
        1.0 * outside);
    return;
  }
  const double bare = coil.wire_diameter;
  if (bare != 0.0 &&
      !(bare >= winding::least_bare_diameter * (1.0 - 1e-12) && bare <= winding::largest_bare_diameter)) {
    const double outside = bare > winding::largest_bare_diameter ? bare / winding::largest_bare_diameter - 1.0
                                                                 : 1.0 - bare / winding::least_bare_diameter;
    list.add(fmt::format("wire diameter must be {:.4g} to {:.4g} mm; got {:.4g} mm", winding::least_bare_diameter * 1e3,
                         winding::largest_bare_diameter * 1e3, bare * 1e3),
             std::isfinite(outside) ? outside : 1.0);
    return;
  }
  if (const double overall = coil.wire_overall; overall != 0.0) {
    const double copper = wire_of({.wire_gauge = awg, .wire_diameter = bare}).largest_bare;
    if (!(std::isfinite(overall) && overall > copper)) {
      list.add(fmt::format("wire over its enamel must be thicker than its copper, {:.4g} mm at most; got {:.4g} mm",
                           copper * 1e3, overall * 1e3),
               std::isfinite(overall) ? copper / std::max(overall, 1e-3 * copper) : 1.0);
      return;
    }
  }
  const winding::Wire wire = wire_of(coil);
  const double smallest = winding::smallest_mandrel_radius * wire.insulated_diameter;
  if (coil.inner_radius < smallest)
    list.add(fmt::format("coil inner radius must be at least {:.4g} mm for {}; got {:.4g} mm", smallest * 1e3,
                         wire.name(), coil.inner_radius * 1e3),
             smallest / coil.inner_radius - 1.0);
}

// A calibrated axis may not sink so far that the parts stand out of the body at the hinge.
void check_axis(const Design& design, MisfitList& list) {
  try {
    const Dimensions size = dimensions(design);
    if (size.axis_offset > size.body_radius) return;
    list.add(fmt::format("hinge axis must lie below the parts, more than {:.4g} mm from their centre; got {:.4g} mm",
                         size.body_radius * 1e3, size.axis_offset * 1e3),
             1.0 - size.axis_offset / size.body_radius);
  } catch (const std::invalid_argument& error) {
    list.add(error.what(), 1.0);  // a calibrated pitch that no packing has
  }
}

void check_shares(const Design& design, MisfitList& list) {
  const std::vector<double> shares = current_shares(design);
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (!(std::abs(shares[i]) <= 1.0))
      list.add(fmt::format("current_share_{} must be from -1 to 1; got {}", i + 1, shares[i]), 1.0);
  // By a share of nearly nothing every limit of the current would be one of nearly anything.
  constexpr double least = 1e-3;
  if (const double largest = largest_current_share(design); largest == 0.0)
    list.add("at least one coil must carry a share of the current; got 0 in all", 1.0);
  else if (largest < least)
    list.add(fmt::format("the largest current share must be at least {}; got {}", least, largest), 1.0);
}

}  // namespace

ConstructionFaults construction_faults(const Design& design) {
  MisfitList list;
  try {
    check_layout(design.layout);
  } catch (const std::invalid_argument& error) {
    list.add(error.what(), 1.0);
  }
  check_sizes(design, list);
  check_surroundings(design, list);
  check_calibration(design.calibration, list);
  check_shares(design, list);
  check_silicone(design.body, "", list);
  if (design.bottom_silicone) check_silicone(*design.bottom_silicone, "bottom layer's ", list);
  if (list.empty()) check_wire(design, list);
  if (list.empty()) check_axis(design, list);
  return list.take();
}

winding::Winding winding_of(const Design& design) {
  const winding::Packing prototype = winding::Packing::prototype();
  return winding::Winding(
      {.inner_radius = design.coil.inner_radius,
       .turns_radial = design.coil.turns_radial,
       .turns_axial = design.coil.turns_axial,
       .wire = wire_of(design.coil),
       .packing = winding::Packing({.axial = prototype.axial() * design.calibration.axial_pitch,
                                    .radial = prototype.radial() * design.calibration.radial_pitch})});
}

Dimensions dimensions(const Design& design) {
  const winding::Winding coil = winding_of(design);
  const BodyDesign& body = design.body;
  Dimensions out;
  out.coil_outer_radius = coil.outer_radius();
  out.coil_length = coil.length();
  out.body_radius = std::max(out.coil_outer_radius, design.magnet.radius);
  out.width = 2.0 * (out.body_radius + body.side_wall);
  out.height = body.bottom_layer + body.bottom_wall + 2.0 * out.body_radius + body.top_wall;
  // The hinge line is the middle of the bottom layer.
  out.axis_offset = design.calibration.axis_offset * (out.body_radius + body.bottom_wall + 0.5 * body.bottom_layer);
  out.coil_half_pitch = 0.5 * out.coil_length + coil_wall_share * body.gap;
  out.magnet_half_pitch = 0.5 * design.magnet.length + (1.0 - coil_wall_share) * body.gap;
  const int coils = coil_count(design.layout);
  const int magnets = magnet_count(design.layout);
  out.effective_length = 2.0 * (coils * out.coil_half_pitch + magnets * out.magnet_half_pitch) + body.front_length;
  out.total_length = out.effective_length + body.rear_length;
  const bool magnet_last = design.layout.back().kind == ComponentKind::magnet;
  out.tip_length = 2.0 * (magnet_last ? out.magnet_half_pitch : out.coil_half_pitch) + body.front_length;
  out.face_height = out.axis_offset + std::min(out.coil_outer_radius, design.magnet.radius);
  out.closing_angle = body.gap / out.face_height;
  return out;
}

double gap_of_joint(const Design& design, int joint) {
  const auto wall = [&](int component) {
    const bool magnet = design.layout[static_cast<std::size_t>(component)].kind == ComponentKind::magnet;
    return magnet ? 1.0 - coil_wall_share : coil_wall_share;
  };
  return (wall(joint) + wall(joint + 1)) * design.body.gap;
}

double face_height_of_joint(const Design& design, const Dimensions& dimensions, int joint) {
  const auto radius = [&](int component) {
    const bool magnet = design.layout[static_cast<std::size_t>(component)].kind == ComponentKind::magnet;
    return magnet ? design.magnet.radius : dimensions.coil_outer_radius;
  };
  return dimensions.axis_offset + std::min(radius(joint), radius(joint + 1));
}

double closing_angle_of_joint(const Design& design, const Dimensions& dimensions, int joint) {
  return gap_of_joint(design, joint) / face_height_of_joint(design, dimensions, joint);
}

}  // namespace coilwright::actuator
