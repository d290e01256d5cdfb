#include "magnetics/coil_on_magnet.hpp"

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/sheet_wrench.hpp"

namespace coilwright::magnetics {

CoilOnMagnet::CoilOnMagnet(const ThickCoil& coil, double current, const CylinderMagnet& magnet)
    : source_(sheets_of(coil, current)), target_(sheets_of(magnet)) {
  if (magnet.recoil_permeability() > 1.0) recoil_.emplace(magnet);
}

// Of what is computed for unit currents, over mu0.
double CoilOnMagnet::scale() const {
  return vacuum_permeability * source_.surface_current * target_.surface_current;
}

double CoilOnMagnet::axial_force(double distance) const {
  const double rigid = axial_force_of_sheets(source_, target_, distance);
  if (!recoil_ || distance == 0.0) return rigid;
  return rigid + scale() * recoil_->axial_force(source_, distance);
}

Wrench CoilOnMagnet::wrench(const Pose& pose, const Accuracy& accuracy) const {
  Wrench total = wrench_of_sheets(source_, target_, pose, accuracy);
  if (!recoil_) return total;
  if (const double sense = sense_on_axis(pose); sense != 0.0) {
    total.force.z() = sense * axial_force(pose.position.z());
    return total;
  }
  const Wrench change = recoil_->wrench(source_, pose.position, pose.axis.normalized(), accuracy);
  total.force += scale() * change.force;
  total.torque += scale() * change.torque;
  return total;
}

}  // namespace coilwright::magnetics
