#include "coilwright/magnetics/pair_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "coilwright/magnetics/axial_force.hpp"
#include "magnetics/recoil_share.hpp"

namespace coilwright::magnetics {
namespace {

Curve::Spec with_boundary_layer(Curve::Spec spec, double boundary_layer_width) {
  if (spec.boundary_layer_width == 0.0)
    spec.boundary_layer_width = std::min(boundary_layer_width, spec.upper - spec.lower);
  return spec;
}

/// Range of the distance of the centres over a range of the joint angle, m.
struct Distances {
  double nearest;
  double farthest;
};

Distances distances_of(const HingeGeometry& geometry, double lower, double upper) {
  const double first = centre_distance(geometry, lower);
  const double last = centre_distance(geometry, upper);
  Distances range{.nearest = std::min(first, last), .farthest = std::max(first, last)};
  // Segments of a shallow joint come nearer again when it opens beyond the angle at which their arm is zero.
  const double widest =
      std::atan2(geometry.axis_offset * (geometry.coil_offset + geometry.magnet_offset),
                 geometry.coil_offset * geometry.magnet_offset - geometry.axis_offset * geometry.axis_offset);
  if (widest > lower && widest < upper) range.farthest = std::max(range.farthest, centre_distance(geometry, widest));
  return range;
}

}  // namespace

Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                   Fidelity fidelity, const Curve::Spec& spec) {
  const auto torque = [&](std::span<const double> angles, std::span<double> torques) {
    std::transform(angles.begin(), angles.end(), torques.begin(),
                   [&](double angle) { return hinge_torque_per_ampere(coil, magnet, geometry, fidelity, angle); });
  };
  // The torque varies over the angle in which the centres move apart by a fraction of their first distance.
  const double reach = 0.5 * (geometry.coil_offset + geometry.magnet_offset) / geometry.axis_offset;
  const Curve::Spec range = with_boundary_layer(spec, 0.3 * reach);
  if (fidelity == Fidelity::exact || magnet.recoil_permeability() == 1.0) return Curve(torque, range);
  const CylinderMagnet rigid = magnet.without_recoil();
  const Distances distances = distances_of(geometry, spec.lower, spec.upper);
  const RecoilShare share(coil, magnet, distances.nearest, distances.farthest);
  const auto weakened = [&](std::span<const double> angles, std::span<double> torques) {
    std::transform(angles.begin(), angles.end(), torques.begin(), [&](double angle) {
      return share.at(centre_distance(geometry, angle)) *
             hinge_torque_per_ampere(coil, rigid, geometry, fidelity, angle);
    });
  };
  return Curve(weakened, range);
}

Curve force_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const Curve::Spec& spec) {
  const CylinderMagnet rigid = magnet.without_recoil();
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    axial_force_per_ampere(coil, rigid, distances, forces);
  };
  const Curve::Spec range = with_boundary_layer(spec, coil.outer_radius());
  if (magnet.recoil_permeability() == 1.0) return Curve(force, range);
  const RecoilShare share(coil, magnet, spec.lower, spec.upper);
  const auto weakened = [&](std::span<const double> distances, std::span<double> forces) {
    force(distances, forces);
    std::transform(distances.begin(), distances.end(), forces.begin(), forces.begin(),
                   [&](double distance, double newtons) { return share.at(distance) * newtons; });
  };
  return Curve(weakened, range);
}

Curve force_curve(const CylinderMagnet& first, const CylinderMagnet& second, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    std::transform(distances.begin(), distances.end(), forces.begin(),
                   [&](double distance) { return axial_force(first, second, distance); });
  };
  return Curve(force, with_boundary_layer(spec, first.radius()));
}

Curve force_curve(const ThickCoil& first, const ThickCoil& second, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    std::transform(distances.begin(), distances.end(), forces.begin(),
                   [&](double distance) { return axial_force(first, 1.0, second, 1.0, distance); });
  };
  return Curve(force, with_boundary_layer(spec, first.outer_radius()));
}

}  // namespace coilwright::magnetics
