#include "coilwright/magnetics/hinge_torque.hpp"

#include <cmath>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/hinge_pose.hpp"
#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

void check(const HingeGeometry& geometry, double angle) {
  const auto offset = [](std::string_view name, double value) {
    require(std::isfinite(value) && value >= 0.0, name, "finite and >= 0", value);
  };
  offset("hinge coil_offset", geometry.coil_offset);
  offset("hinge magnet_offset", geometry.magnet_offset);
  require(geometry.coil_offset + geometry.magnet_offset > 0.0, "hinge coil_offset + magnet_offset", "> 0",
          geometry.coil_offset + geometry.magnet_offset);
  require_positive("hinge axis_offset", geometry.axis_offset);
  require_finite("hinge angle", angle);
}

/// The magnet's centre less the coil's: x towards the joint, y along the coil's axis from joint to coil.
struct Separation {
  double across;
  double along;
};

Separation separation(const HingeGeometry& g, double angle) {
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  return {g.axis_offset * (1.0 - cosine) + g.magnet_offset * sine,
          -(g.coil_offset + g.magnet_offset * cosine + g.axis_offset * sine)};
}

}  // namespace

Pose hinge_pose(const HingeGeometry& geometry, double angle) {
  const Separation at = separation(geometry, angle);
  return {.position = {at.across, 0.0, at.along}, .axis = {-std::sin(angle), 0.0, std::cos(angle)}};
}

double torque_about_hinge(const Wrench& on_magnet, const HingeGeometry& geometry, double angle) {
  const Separation at = separation(geometry, angle);
  const double arm_x = at.across - geometry.axis_offset;
  const double arm_z = at.along + geometry.coil_offset;
  return on_magnet.torque.y() + arm_z * on_magnet.force.x() - arm_x * on_magnet.force.z();
}

double centre_distance(const HingeGeometry& geometry, double angle) {
  check(geometry, angle);
  const Separation at = separation(geometry, angle);
  return std::hypot(at.across, at.along);
}

double centre_distance_derivative(const HingeGeometry& g, double angle) {
  check(g, angle);
  const Separation at = separation(g, angle);
  const double arm = g.axis_offset * (g.coil_offset + g.magnet_offset) * std::cos(angle) +
                     (g.axis_offset * g.axis_offset - g.coil_offset * g.magnet_offset) * std::sin(angle);
  return arm / std::hypot(at.across, at.along);
}

double hinge_torque_per_ampere(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                               Fidelity fidelity, double angle) {
  check(geometry, angle);
  if (fidelity == Fidelity::exact)
    return torque_about_hinge(wrench(coil, 1.0, magnet, hinge_pose(geometry, angle)), geometry, angle);
  return -axial_force(coil, 1.0, magnet, centre_distance(geometry, angle)) *
         centre_distance_derivative(geometry, angle);
}

}  // namespace coilwright::magnetics
