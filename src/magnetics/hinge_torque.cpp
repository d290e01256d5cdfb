#include "coilwright/magnetics/hinge_torque.hpp"

#include <cmath>

#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/hinge_pair.hpp"
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

// Where the magnet of a hinge is in the coil's frame: the coil at the origin, +z its axis away from the joint, +x from
// the axis towards the joint. So +y is the axis about which a negative turn opens the joint.
Pose pose_at(const HingeGeometry& geometry, double angle) {
  const Separation at = separation(geometry, angle);
  return {.position = {at.across, 0.0, at.along}, .axis = {-std::sin(angle), 0.0, std::cos(angle)}};
}

// Torque by which a wrench on the magnet, about its centre and in the coil's frame, opens the hinge where its currents
// run against the coil's, N m. With the magnet's moment along its axis an ampere of the coil attracts, so both signs
// turn: it is the torque about +y.
double torque_about_hinge(const Wrench& on_magnet, const HingeGeometry& geometry, double angle) {
  const Separation at = separation(geometry, angle);
  const double arm_x = at.across - geometry.axis_offset;
  const double arm_z = at.along + geometry.coil_offset;
  return on_magnet.torque.y() + arm_z * on_magnet.force.x() - arm_x * on_magnet.force.z();
}

}  // namespace

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

double HingePair::torque(Fidelity fidelity, double angle, const Accuracy& accuracy) const {
  check(geometry, angle);
  if (fidelity == Fidelity::exact)
    return torque_about_hinge(bodies.wrench(pose_at(geometry, angle), accuracy), geometry, angle);
  return -bodies.axial_force(centre_distance(geometry, angle)) * centre_distance_derivative(geometry, angle);
}

double hinge_torque_per_ampere(const ThickCoil& coil, const CylinderMagnet& magnet, const HingeGeometry& geometry,
                               Fidelity fidelity, double angle) {
  const HingePair pair{.bodies = CoilOnMagnet(coil, 1.0, magnet), .geometry = geometry};
  return pair.torque(fidelity, angle, accuracy_of_pose);
}

}  // namespace coilwright::magnetics
