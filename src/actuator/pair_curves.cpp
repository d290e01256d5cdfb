#include "actuator/pair_curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/parts/axial_curves.hpp"
#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/pair_curve.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::actuator {
namespace {

// Far beyond what a joint of segments can open to before they fold onto each other.
constexpr double widest_angle = 120.0 * std::numbers::pi / 180.0;

magnetics::ThickCoil thick_coil(const Design& design, const Dimensions& size) {
  return magnetics::ThickCoil({.inner_radius = design.coil.inner_radius,
                               .outer_radius = size.coil_outer_radius,
                               .length = size.coil_length,
                               .turns_radial = design.coil.turns_radial,
                               .turns_axial = design.coil.turns_axial,
                               .winding = design.choices.winding});
}

struct Range {
  double lower{};
  double upper{};
};

// Distances between the centres of two components that are not neighbours, `length` long together. Closing joints
// bring them at most a tenth nearer than a straight chain does, and never nearer than they touch (thin parts between
// long ones); opening takes two centres across a joint to at most twice their distance from it.
// The range goes on to ten radii, where the force is a dipole's within 3 %.
Range distances(const Design& design, const Dimensions& size, double straight, double length) {
  const double half = std::max(size.coil_half_pitch, size.magnet_half_pitch);
  const double joints = static_cast<double>(design.layout.size()) - 1.0;
  const double opened = 2.0 * joints * std::hypot(size.axis_offset, half);
  return {.lower = std::max(0.9 * straight, 0.5 * length), .upper = std::max(opened, 10.0 * size.body_radius)};
}

// Angle by which a joint closes until a part that reaches `height` above the hinge line, its wall `own` thick, meets
// the face of the other part, whose wall is `other`: sin(angle - atan(own / height)) is other over the corner's
// distance.
double meeting_angle(double height, double own, double other) {
  return std::atan2(own, height) + std::asin(std::min(1.0, other / std::hypot(own, height)));
}

// Where the parts of a hinge pair touch. `closing_angle` is the same to first order in gap over height, and inside the
// copper by up to 0.1 mm for wide gaps.
double touching_angle(const Design& design, const Dimensions& size) {
  const double coil_wall = size.coil_half_pitch - 0.5 * size.coil_length;
  const double magnet_wall = size.magnet_half_pitch - 0.5 * design.magnet.length;
  return std::min(meeting_angle(size.axis_offset + design.magnet.radius, magnet_wall, coil_wall),
                  meeting_angle(size.axis_offset + size.coil_outer_radius, coil_wall, magnet_wall));
}

}  // namespace

magnetics::ThickCoil PairCurves::coil() const {
  return thick_coil(design_, size_);
}

magnetics::CylinderMagnet PairCurves::magnet() const {
  return design_.magnet.cylinder();
}

double PairCurves::rest_force_per_ampere() const {
  // Like senses attract; positive current is the sense that repels.
  return -magnetics::axial_force(thick_coil(design_, size_), 1.0, design_.magnet.cylinder(),
                                 size_.coil_half_pitch + size_.magnet_half_pitch);
}

std::shared_ptr<const HingePairParts> PairCurves::hinge_parts() {
  if (!hinge_parts_)
    hinge_parts_ = std::make_shared<const HingePairParts>(
        HingePairParts::Spec{.coil = coil(),
                             .magnet = design_.magnet.cylinder(),
                             .geometry = {.coil_offset = size_.coil_half_pitch,
                                          .magnet_offset = size_.magnet_half_pitch,
                                          .axis_offset = size_.axis_offset},
                             .fidelity = design_.choices.torque,
                             .range = {.lower = -std::min(size_.closing_angle, touching_angle(design_, size_)),
                                       .upper = widest_angle,
                                       .tolerance = design_.curve_tolerance}});
  return hinge_parts_;
}

std::shared_ptr<const magnetics::Curve> PairCurves::hinge_torque() {
  if (!hinge_torque_) hinge_torque_ = hinge_parts()->torque();
  return hinge_torque_;
}

const AxialCurves& PairCurves::coil_magnet() {
  if (!coil_magnet_.force) {
    const double straight = size_.coil_half_pitch * 3.0 + size_.magnet_half_pitch;
    const Range range = distances(design_, size_, straight, size_.coil_length + design_.magnet.length);
    coil_magnet_ = axial_curves(
        magnetics::force_curve(thick_coil(design_, size_), design_.magnet.cylinder(),
                               {.lower = range.lower, .upper = range.upper, .tolerance = design_.curve_tolerance}),
        design_.curve_tolerance);
  }
  return coil_magnet_;
}

const AxialCurves& PairCurves::magnet_magnet() {
  if (!magnet_magnet_.force) {
    const double straight = 2.0 * (size_.coil_half_pitch + size_.magnet_half_pitch);
    const Range range = distances(design_, size_, straight, 2.0 * design_.magnet.length);
    magnet_magnet_ = axial_curves(
        magnetics::force_curve(design_.magnet.cylinder(), design_.magnet.cylinder(),
                               {.lower = range.lower, .upper = range.upper, .tolerance = design_.curve_tolerance}),
        design_.curve_tolerance);
  }
  return magnet_magnet_;
}

}  // namespace coilwright::actuator
