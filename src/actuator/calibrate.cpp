#include "coilwright/actuator/calibrate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "actuator/heat_chain.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/actuator/hinges.hpp"
#include "coilwright/winding/winding.hpp"

namespace coilwright::actuator {
namespace {

void check_positive(double measured, const char* name) {
  if (!std::isfinite(measured) || measured <= 0.0)
    throw std::invalid_argument(fmt::format("measured {} must be finite and > 0; got {}", name, measured));
}

double ratio(double measured, double derived, const char* name) {
  check_positive(measured, name);
  return measured / derived;
}

void require_buildable(const Design& design) {
  if (const ConstructionFaults broken = construction_faults(design); !broken.empty())
    throw std::invalid_argument(broken.front().rule);
}

// Pitch of `layers` layers that are `thickness` thick together: the outermost takes its wire's whole diameter where
// layers sink into each other's grooves.
double layer_pitch(double thickness, int layers, double diameter) {
  if (layers == 1 || thickness >= layers * diameter) return thickness / layers;
  return (thickness - diameter) / (layers - 1);
}

void calibrate_pitches(Design& design, const Measured& measured) {
  const winding::Winding coil = winding_of(design);
  if (measured.coil_outer_radius) {
    const double thickness = *measured.coil_outer_radius - coil.inner_radius();
    if (!(thickness > 0.0) || !std::isfinite(thickness))
      throw std::invalid_argument(
          fmt::format("measured coil outer radius must exceed the inner one ({:.6g} mm); got {:.6g} mm",
                      coil.inner_radius() * 1e3, *measured.coil_outer_radius * 1e3));
    design.calibration.radial_pitch =
        layer_pitch(thickness, design.coil.turns_radial, coil.wire().insulated_diameter) / coil.radial_pitch();
    require_buildable(design);
  }
  // After the layers: those that sink into each other make the coil longer.
  if (measured.coil_length) {
    design.calibration.axial_pitch = ratio(*measured.coil_length, winding_of(design).length(), "coil length");
    require_buildable(design);
  }
}

// A segment of the kind that was weighed; nullptr where the design has none.
const Segment* inner_magnet_segment(const Design& design, const Assembly& assembly) {
  for (std::size_t i = 1; i + 1 < design.layout.size(); ++i)
    if (design.layout[i].kind == ComponentKind::magnet) return &assembly.segments[i];
  return nullptr;
}

void calibrate_masses(Design& design, const Measured& measured, const Assembly& derived) {
  if (measured.magnet_segment_mass) {
    const Segment* magnet = inner_magnet_segment(design, derived);
    if (magnet == nullptr)
      throw std::invalid_argument(
          "measured magnet segment mass: no magnet of this layout lies between two other parts");
    design.calibration.magnet_segment_mass = ratio(*measured.magnet_segment_mass, magnet->mass, "magnet segment mass");
  }
  if (measured.tip_segment_mass) {
    if (design.layout.back().kind != ComponentKind::coil)
      throw std::invalid_argument("measured tip segment mass: the last component of this layout is not a coil");
    design.calibration.coil_segment_mass =
        ratio(*measured.tip_segment_mass, derived.segments.back().mass, "tip segment mass");
  }
  if (measured.tip_com)
    design.calibration.tip_com = ratio(*measured.tip_com, derived.segments.back().com_along, "tip centre of mass");
}

}  // namespace

Calibration calibrate(Design design, const Measured& measured) {
  design.calibration = {};
  // Geometry does not depend on forces: the cheap fidelity serves here.
  design.choices.torque = magnetics::Fidelity::line_of_centres;
  design.coil.current_shares.fill(1.0);  // what was measured was measured with one current in all coils
  require_buildable(design);
  calibrate_pitches(design, measured);
  if (measured.axis_offset)
    design.calibration.axis_offset = ratio(*measured.axis_offset, dimensions(design).axis_offset, "axis offset");

  const Assembly derived = assemble_or_throw(design);
  calibrate_masses(design, measured, derived);
  if (measured.joint_stiffness || measured.joint_damping)
    design = with_measured_hinge(design, measured.joint_stiffness, measured.joint_damping);
  if (measured.coil_resistance)
    design.calibration.coil_resistance = ratio(*measured.coil_resistance, derived.coil.resistance, "coil resistance");
  if (measured.continuous_current) {
    const double current = *measured.continuous_current;
    check_positive(current, "continuous current");
    const Assembly calibrated = assemble_or_throw(design);
    const thermal::HeatChain chain =
        heat_chain(design, calibrated,
                   joints_at(calibrated, measured.continuous_current_joint_angle.value_or(thermal_joint_angle)));
    design.calibration.heat_transfer =
        thermal::calibrate_heat_transfer(chain, current) / design.surroundings.heat_transfer;
  }
  return design.calibration;
}

}  // namespace coilwright::actuator
