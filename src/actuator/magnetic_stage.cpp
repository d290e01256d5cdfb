#include "coilwright/actuator/magnetic_stage.hpp"

#include <cmath>
#include <utility>

namespace coilwright::actuator {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;
using mechanics::LinkPoint;
using mechanics::PlanarChain;

double link_angle(int link, const JointVector& angles) {
  double sum = 0.0;
  for (int j = 0; j <= link; ++j) sum += angles[j];
  return sum;
}

Eigen::Vector2d axis(double link_angle) {
  return {std::sin(link_angle), -std::cos(link_angle)};
}
Eigen::Vector2d axis_slope(double link_angle) {
  return {std::cos(link_angle), std::sin(link_angle)};
}

// dU/d(distance vector) and dU/d(link angle) of both ends.
struct EnergySlope {
  Eigen::Vector2d distance;
  double first_angle{};
  double second_angle{};
};

EnergySlope energy_slope(const DistantPair& pair, const Eigen::Vector2d& between, double first_angle,
                         double second_angle) {
  const double z = between.norm();
  const Eigen::Vector2d unit = between / z;
  const double force = pair.axial_force->value(z);
  if (pair.orientation == DistantPair::Orientation::ignored) return {.distance = -force * unit};

  const double energy = pair.axial_energy->value(z);
  const Eigen::Vector2d a = axis(first_angle);
  const Eigen::Vector2d b = axis(second_angle);
  const double az = a.dot(unit);
  const double bz = b.dot(unit);
  const double shape = 0.5 * (3.0 * az * bz - a.dot(b));
  const Eigen::Vector2d shape_slope = 1.5 * (bz * (a - az * unit) + az * (b - bz * unit)) / z;
  return {
      .distance = -force * shape * unit + energy * shape_slope,
      .first_angle = 0.5 * energy * (3.0 * bz * axis_slope(first_angle).dot(unit) - axis_slope(first_angle).dot(b)),
      .second_angle = 0.5 * energy * (3.0 * az * axis_slope(second_angle).dot(unit) - axis_slope(second_angle).dot(a))};
}

}  // namespace

MagneticStage::MagneticStage(std::vector<HingePair> hinge_pairs, std::vector<DistantPair> distant_pairs)
    : hinge_pairs_(std::move(hinge_pairs)), distant_pairs_(std::move(distant_pairs)) {}

void MagneticStage::add_torques(const PlanarChain& chain, const JointVector& angles, const CoilCurrents& currents,
                                JointVector& torques) const {
  for (const HingePair& pair : hinge_pairs_) {
    torques[pair.joint] += pair.sense * currents[pair.coil] * pair.torque_per_ampere->value(angles[pair.joint]);
  }
  if (!distant_pairs_.empty()) add_distant_torques(chain, angles, currents, torques);
}

void MagneticStage::add_distant_torques(const PlanarChain& chain, const JointVector& angles,
                                        const CoilCurrents& currents, JointVector& torques) const {
  for (const DistantPair& pair : distant_pairs_) {
    const double strength = pair.sense * (pair.coil < 0 ? 1.0 : currents[pair.coil]);
    if (strength == 0.0) continue;
    const Eigen::Vector2d between = chain.position(pair.second, angles) - chain.position(pair.first, angles);
    const EnergySlope slope =
        energy_slope(pair, between, link_angle(pair.first.link, angles), link_angle(pair.second.link, angles));
    const mechanics::PointJacobian motion = chain.jacobian(pair.second, angles) - chain.jacobian(pair.first, angles);
    for (int j = 0; j <= pair.second.link; ++j) {
      double torque = -motion.col(j).dot(slope.distance) - slope.second_angle;
      if (j <= pair.first.link) torque -= slope.first_angle;
      torques[j] += strength * torque;
    }
  }
}

void MagneticStage::add_stiffness(const PlanarChain& chain, const JointVector& angles, const CoilCurrents& currents,
                                  JointMatrix& stiffness) const {
  for (const HingePair& pair : hinge_pairs_) {
    stiffness(pair.joint, pair.joint) -=
        pair.sense * currents[pair.coil] * pair.torque_per_ampere->derivative(angles[pair.joint]);
  }
  if (distant_pairs_.empty()) return;
  constexpr double step = 1e-5;
  const int n = chain.joints();
  for (int j = 0; j < n; ++j) {
    JointVector shifted = angles;
    JointVector ahead = JointVector::Zero(n);
    JointVector behind = JointVector::Zero(n);
    shifted[j] = angles[j] + step;
    add_distant_torques(chain, shifted, currents, ahead);
    shifted[j] = angles[j] - step;
    add_distant_torques(chain, shifted, currents, behind);
    stiffness.col(j) -= (ahead - behind) / (2.0 * step);
  }
}

}  // namespace coilwright::actuator
