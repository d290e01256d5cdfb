#include "coilwright/magnetics/wrench.hpp"

#include <cmath>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "magnetics/radial_nodes.hpp"
#include "magnetics/recoil_currents.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheets.hpp"
#include "magnetics/surface_quadrature.hpp"

namespace coilwright::magnetics {
namespace {

void check(const Pose& pose) {
  require(pose.position.allFinite(), "pose position", "finite", pose.position.norm());
  require(pose.axis.allFinite() && pose.axis.norm() > 0.0, "pose axis", "finite and not zero", pose.axis.norm());
}

void add(Wrench& total, const Wrench& part, double weight) {
  total.force += weight * part.force;
  total.torque += weight * part.torque;
}

// Of what is computed for unit currents, over mu0.
double scale_of(const SheetBody& first, const SheetBody& second) {
  return vacuum_permeability * first.surface_current * second.surface_current;
}

Wrench wrench_between(const SheetBody& first, const SheetBody& second, const Pose& pose) {
  const Eigen::Vector3d axis = pose.axis.normalized();
  const SheetNodes sheets(second, 23.0);
  Wrench total;
  for (int i = 0; i < sheets.count(); ++i) {
    const TargetSheet target{.radius = sheets.radius(i), .half_length = second.half_length};
    add(total, lorentz_wrench(first, target, pose.position, axis), sheets.weight(i));
  }
  const double scale = scale_of(first, second);
  total.force *= scale;
  total.torque *= scale;
  return total;
}

// The sense of a second body on the common axis (+1 or -1 as its own axis points along z or against it), 0 off the
// axis. There the closed form is exact to 1e-10 where the quadrature over a sheet is not, with faces level or touching.
double sense_on_axis(const Pose& pose) {
  constexpr double rounding = 1e-15;  // what normalising leaves of the sideways parts of an axis along z
  const Eigen::Vector3d axis = pose.axis.normalized();
  const bool coaxial =
      pose.position.x() == 0.0 && pose.position.y() == 0.0 && std::hypot(axis.x(), axis.y()) <= rounding;
  return coaxial ? std::copysign(1.0, axis.z()) : 0.0;
}

Wrench along_axis(double force) {
  return {.force = {0.0, 0.0, force}, .torque = Eigen::Vector3d::Zero()};
}

}  // namespace

Wrench wrench(const ThickCoil& coil, double current, const CylinderMagnet& magnet, const Pose& pose) {
  require_finite("current", current);
  check(pose);
  if (const double sense = sense_on_axis(pose); sense != 0.0)
    return along_axis(sense * axial_force(coil, current, magnet, pose.position.z()));
  const SheetBody source = sheets_of(coil, current);
  const SheetBody target = sheets_of(magnet);
  Wrench total = wrench_between(source, target, pose);
  if (magnet.recoil_permeability() > 1.0)
    add(total, RecoilCurrents(magnet).wrench(source, pose.position, pose.axis.normalized()), scale_of(source, target));
  return total;
}

Wrench wrench(const CylinderMagnet& first, const CylinderMagnet& second, const Pose& pose) {
  check(pose);
  if (const double sense = sense_on_axis(pose); sense != 0.0)
    return along_axis(sense * axial_force(first, second, pose.position.z()));
  return wrench_between(weakened_sheets_of(first), weakened_sheets_of(second), pose);
}

Wrench wrench(const ThickCoil& first, double first_current, const ThickCoil& second, double second_current,
              const Pose& pose) {
  require_finite("first_current", first_current);
  require_finite("second_current", second_current);
  check(pose);
  if (const double sense = sense_on_axis(pose); sense != 0.0)
    return along_axis(sense * axial_force(first, first_current, second, second_current, pose.position.z()));
  return wrench_between(sheets_of(first, first_current), sheets_of(second, second_current), pose);
}

}  // namespace coilwright::magnetics
