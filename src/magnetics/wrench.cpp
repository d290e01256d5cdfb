#include "coilwright/magnetics/wrench.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/coil_on_magnet.hpp"
#include "magnetics/radial_nodes.hpp"
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

Wrench wrench_between(const SheetBody& first, const SheetBody& second, const Pose& pose, const Accuracy& accuracy) {
  const Eigen::Vector3d axis = pose.axis.normalized();
  const SheetNodes sheets(second, 23.0);
  Wrench total;
  for (int i = 0; i < sheets.count(); ++i) {
    const TargetSheet target{.radius = sheets.radius(i), .half_length = second.half_length};
    const Wrench sheet = lorentz_wrench(first, target, pose.position, axis, accuracy);
    total.force += sheets.weight(i) * sheet.force;
    total.torque += sheets.weight(i) * sheet.torque;
  }
  const double scale = vacuum_permeability * first.surface_current * second.surface_current;
  total.force *= scale;
  total.torque *= scale;
  return total;
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
  return CoilOnMagnet(coil, current, magnet).wrench(pose, accuracy_of_pose);
}

double sense_on_axis(const Pose& pose) {
  constexpr double rounding = 1e-15;  // what normalising leaves of the sideways parts of an axis along z
  const Eigen::Vector3d axis = pose.axis.normalized();
  const bool coaxial =
      pose.position.x() == 0.0 && pose.position.y() == 0.0 && std::hypot(axis.x(), axis.y()) <= rounding;
  return coaxial ? std::copysign(1.0, axis.z()) : 0.0;
}

Wrench wrench_of_sheets(const SheetBody& first, const SheetBody& second, const Pose& pose, const Accuracy& accuracy) {
  check(pose);
  if (const double sense = sense_on_axis(pose); sense != 0.0)
    return {.force = {0.0, 0.0, sense * axial_force_of_sheets(first, second, pose.position.z())},
            .torque = Eigen::Vector3d::Zero()};
  return wrench_between(first, second, pose, accuracy);
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
