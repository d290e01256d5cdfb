#include "coilwright/magnetics/pair_curve.hpp"

#include <algorithm>
#include <span>

#include "coilwright/magnetics/axial_force.hpp"
#include "magnetics/hinge_pair.hpp"

namespace coilwright::magnetics {
namespace {

Curve::Spec with_boundary_layer(Curve::Spec spec, double boundary_layer_width) {
  if (spec.boundary_layer_width == 0.0)
    spec.boundary_layer_width = std::min(boundary_layer_width, spec.upper - spec.lower);
  return spec;
}

}  // namespace

Curve torque_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                   Fidelity fidelity, const Curve::Spec& spec) {
  // The torque varies over the angle in which the centres move apart by a fraction of their first distance.
  const double reach = 0.5 * (geometry.coil_offset + geometry.magnet_offset) / geometry.axis_offset;
  const Curve::Spec range = with_boundary_layer(spec, 0.3 * reach);
  const HingePair pair{.bodies = CoilOnMagnet(coil, 1.0, magnet), .geometry = geometry};
  const Accuracy& accuracy = spec.tolerance < 1e-6 ? accuracy_of_pose : accuracy_of_curve;
  const auto torque = [&](std::span<const double> angles, std::span<double> torques) {
    std::transform(angles.begin(), angles.end(), torques.begin(),
                   [&](double angle) { return pair.torque(fidelity, angle, accuracy); });
  };
  return Curve(torque, range);
}

Curve force_curve(const ThickCoil& coil, const CylinderMagnet& magnet, const Curve::Spec& spec) {
  const auto force = [&](std::span<const double> distances, std::span<double> forces) {
    axial_force_per_ampere(coil, magnet, distances, forces);
  };
  return Curve(force, with_boundary_layer(spec, coil.outer_radius()));
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
