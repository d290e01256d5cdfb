#include "coilwright/magnetics/wrench.hpp"

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/radial_nodes.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheets.hpp"
#include "magnetics/surface_quadrature.hpp"

namespace coilwright::magnetics {
namespace {

Wrench wrench_between(const SheetBody& first, const SheetBody& second, const Pose& pose) {
  require(pose.position.allFinite(), "pose position", "finite", pose.position.norm());
  require(pose.axis.allFinite() && pose.axis.norm() > 0.0, "pose axis", "finite and not zero", pose.axis.norm());
  const Eigen::Vector3d axis = pose.axis.normalized();
  const SheetNodes sheets(second, 23.0);
  Wrench total;
  for (int i = 0; i < sheets.count(); ++i) {
    const TargetSheet target{.radius = sheets.radius(i), .half_length = second.half_length};
    const Wrench part = lorentz_wrench(first, target, pose.position, axis);
    total.force += sheets.weight(i) * part.force;
    total.torque += sheets.weight(i) * part.torque;
  }
  const double scale = vacuum_permeability * first.surface_current * second.surface_current;
  total.force *= scale;
  total.torque *= scale;
  return total;
}

}  // namespace

Wrench wrench(const ThickCoil& coil, double current, const CylinderMagnet& magnet, const Pose& pose) {
  require_finite("current", current);
  return wrench_between(sheets_of(coil, current), sheets_of(magnet), pose);
}

Wrench wrench(const CylinderMagnet& first, const CylinderMagnet& second, const Pose& pose) {
  return wrench_between(sheets_of(first), sheets_of(second), pose);
}

Wrench wrench(const ThickCoil& first, double first_current, const ThickCoil& second, double second_current,
              const Pose& pose) {
  require_finite("first_current", first_current);
  require_finite("second_current", second_current);
  return wrench_between(sheets_of(first, first_current), sheets_of(second, second_current), pose);
}

}  // namespace coilwright::magnetics
