#include "actuator/pair_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::actuator {
namespace {

// Far beyond what a joint of segments can open to before they fold onto each other.
constexpr double widest_angle = 120.0 * std::numbers::pi / 180.0;

// Relative to a curve's largest value; two orders below the 1e-5 to which a coil is wound.
constexpr double curve_tolerance = 1e-6;

magnetics::ThickCoil thick_coil(const Design& design, const Dimensions& size) {
  return magnetics::ThickCoil({.inner_radius = design.coil.inner_radius,
                               .outer_radius = size.coil_outer_radius,
                               .length = size.coil_length,
                               .turns_radial = design.coil.turns_radial,
                               .turns_axial = design.coil.turns_axial,
                               .winding = design.choices.winding});
}

magnetics::CylinderMagnet magnet_of(const Design& design) {
  return magnetics::CylinderMagnet(
      {.radius = design.magnet.radius, .length = design.magnet.length, .remanence = design.magnet.remanence});
}

struct Range {
  double lower{};
  double upper{};
};

// Distances between the centres of two components that are not neighbours. Closing joints bring them at most a tenth
// nearer than a straight chain does; opening takes two centres across a joint to at most twice their distance from it.
// The range goes on to ten radii, where the force is a dipole's within 3 %.
Range distances(const Design& design, const Dimensions& size, double straight) {
  const double half = std::max(size.coil_half_pitch, size.magnet_half_pitch);
  const double joints = static_cast<double>(design.layout.size()) - 1.0;
  const double opened = 2.0 * joints * std::hypot(size.axis_offset, half);
  return {.lower = 0.9 * straight, .upper = std::max(opened, 10.0 * size.body_radius)};
}

}  // namespace

magnetics::ThickCoil PairCurves::coil() const {
  return thick_coil(design_, size_);
}

double PairCurves::rest_force_per_ampere() const {
  // Like senses attract; positive current is the sense that repels.
  return -magnetics::axial_force(thick_coil(design_, size_), 1.0, magnet_of(design_),
                                 size_.coil_half_pitch + size_.magnet_half_pitch);
}

std::shared_ptr<const HingePairParts> PairCurves::hinge_parts() {
  if (!hinge_parts_)
    hinge_parts_ = std::make_shared<const HingePairParts>(HingePairParts::Spec{
        .coil = coil(),
        .magnet = magnet_of(design_),
        .geometry = {.coil_offset = size_.coil_half_pitch,
                     .magnet_offset = size_.magnet_half_pitch,
                     .axis_offset = size_.axis_offset},
        .fidelity = design_.choices.torque,
        .range = {.lower = -size_.closing_angle, .upper = widest_angle, .tolerance = curve_tolerance}});
  return hinge_parts_;
}

std::shared_ptr<const magnetics::Curve> PairCurves::hinge_torque() {
  if (!hinge_torque_) hinge_torque_ = hinge_parts()->torque();
  return hinge_torque_;
}

const AxialCurves& PairCurves::coil_magnet() {
  if (!coil_magnet_.force) {
    const double straight = size_.coil_half_pitch * 3.0 + size_.magnet_half_pitch;
    const Range range = distances(design_, size_, straight);
    coil_magnet_ = axial_curves(
        magnetics::force_curve(thick_coil(design_, size_), magnet_of(design_),
                               {.lower = range.lower, .upper = range.upper, .tolerance = curve_tolerance}));
  }
  return coil_magnet_;
}

const AxialCurves& PairCurves::magnet_magnet() {
  if (!magnet_magnet_.force) {
    const double straight = 2.0 * (size_.coil_half_pitch + size_.magnet_half_pitch);
    const Range range = distances(design_, size_, straight);
    magnet_magnet_ = axial_curves(
        magnetics::force_curve(magnet_of(design_), magnet_of(design_),
                               {.lower = range.lower, .upper = range.upper, .tolerance = curve_tolerance}));
  }
  return magnet_magnet_;
}

}  // namespace coilwright::actuator
