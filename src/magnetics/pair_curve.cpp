#include "coilwright/magnetics/pair_curve.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "magnetics/hinge_pose.hpp"
#include "magnetics/recoil_currents.hpp"
#include "magnetics/recoil_share.hpp"
#include "magnetics/sheets.hpp"

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

// What recoil adds to the exact torque: some hundredths of it, at three times the cost of the rest. The curve's bound
// overrates what so smooth a function misses by a hundred times and more: within 5e-8 of the whole torque at 1e-4.
Curve recoil_torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                          Curve::Spec spec) {
  const RecoilCurrents recoil(magnet);
  const SheetBody source = sheets_of(coil, 1.0);
  const double scale = vacuum_permeability * source.surface_current * sheets_of(magnet).surface_current;
  const auto torque = [&](std::span<const double> angles, std::span<double> torques) {
    std::transform(angles.begin(), angles.end(), torques.begin(), [&](double angle) {
      const Pose pose = hinge_pose(geometry, angle);
      return scale * torque_about_hinge(recoil.wrench(source, pose.position, pose.axis), geometry, angle);
    });
  };
  spec.tolerance = std::min(100.0 * spec.tolerance, 1e-2);
  return Curve(torque, spec);
}

}  // namespace

Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                   Fidelity fidelity, const Curve::Spec& spec) {
  // The torque varies over the angle in which the centres move apart by a fraction of their first distance.
  const double reach = 0.5 * (geometry.coil_offset + geometry.magnet_offset) / geometry.axis_offset;
  const Curve::Spec range = with_boundary_layer(spec, 0.3 * reach);
  const CylinderMagnet rigid = magnet.without_recoil();
  const auto without_recoil = [&](double angle) {
    return hinge_torque_per_ampere(coil, rigid, geometry, fidelity, angle);
  };
  const auto of_each = [](const auto& torque) {
    return [&torque](std::span<const double> angles, std::span<double> torques) {
      std::transform(angles.begin(), angles.end(), torques.begin(), torque);
    };
  };
  if (magnet.recoil_permeability() == 1.0) return Curve(of_each(without_recoil), range);
  if (fidelity == Fidelity::exact) {
    const Curve recoil = recoil_torque_curve(coil, magnet, geometry, range);
    const auto torque = [&](double angle) { return without_recoil(angle) + recoil.value(angle); };
    return Curve(of_each(torque), range);
  }
  const Distances distances = distances_of(geometry, spec.lower, spec.upper);
  const RecoilShare share(coil, magnet, distances.nearest, distances.farthest);
  const auto weakened = [&](double angle) {
    return share.at(centre_distance(geometry, angle)) * without_recoil(angle);
  };
  return Curve(of_each(weakened), range);
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
