#include "coilwright/magnetics/wrench.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "magnetics/radial_nodes.hpp"
#include "magnetics/recoil_currents.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheet_wrench.hpp"
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

Eigen::Matrix3d rotation_of(const Pose& pose) {
  check(pose);
  require(pose.x_axis.allFinite(), "pose x axis", "finite", pose.x_axis.norm());
  constexpr double least_across = 1e-6;  // of the whole
  const Eigen::Vector3d z = pose.axis.normalized();
  const Eigen::Vector3d across = pose.x_axis - pose.x_axis.dot(z) * z;
  const bool along = across.norm() <= least_across * pose.x_axis.norm();
  Eigen::Matrix3d axes;
  axes.col(2) = z;
  axes.col(0) = (along ? Eigen::Vector3d(Eigen::Vector3d::UnitY() - z.y() * z) : across).normalized();
  axes.col(1) = z.cross(axes.col(0));
  return axes;
}

Pose seen_from(const Pose& first, const Pose& pose) {
  const Eigen::Matrix3d to_first = rotation_of(first).transpose();
  return {.position = to_first * (pose.position - first.position),
          .axis = to_first * pose.axis,
          .x_axis = to_first * pose.x_axis};
}

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

Wrench wrench_of_sheets(const SheetBody& first, const SheetBody& second, const Pose& pose) {
  check(pose);
  if (const double sense = sense_on_axis(pose); sense != 0.0)
    return along_axis(sense * axial_force_of_sheets(first, second, pose.position.z()));
  return wrench_between(first, second, pose);
}

Wrench wrench(const CylinderMagnet& first, const CylinderMagnet& second, const Pose& pose) {
  return wrench_of_sheets(weakened_sheets_of(first), weakened_sheets_of(second), pose);
}

Wrench wrench(const ThickCoil& first, double first_current, const ThickCoil& second, double second_current,
              const Pose& pose) {
  require_finite("first_current", first_current);
  require_finite("second_current", second_current);
  return wrench_of_sheets(sheets_of(first, first_current), sheets_of(second, second_current), pose);
}

}  // namespace coilwright::magnetics
