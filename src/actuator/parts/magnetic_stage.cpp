#include "coilwright/actuator/parts/magnetic_stage.hpp"

#include <cmath>
#include <utility>

namespace coilwright::actuator {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;
using mechanics::LinkFrame;
using mechanics::PlanarChain;

// dU/d(distance vector) and dU/d(angle of the second body).
struct EnergySlope {
  Eigen::Vector2d distance;
  double second_angle{};
};

EnergySlope energy_slope(const DistantPair& pair, const Eigen::Vector2d& between, const LinkFrame& first,
                         const LinkFrame& second) {
  const double z = between.norm();
  const Eigen::Vector2d unit = between / z;
  const double force = pair.axial_force->value(z);
  if (pair.orientation == DistantPair::Orientation::ignored) return {.distance = -force * unit};

  const double energy = pair.axial_energy->value(z);
  const Eigen::Vector2d a = first.axis();
  const Eigen::Vector2d b = second.axis();
  const Eigen::Vector2d b_slope(second.cosine, second.sine);
  const double az = a.dot(unit);
  const double bz = b.dot(unit);
  const double shape = 0.5 * (3.0 * az * bz - a.dot(b));
  const Eigen::Vector2d shape_slope = 1.5 * (bz * (a - az * unit) + az * (b - bz * unit)) / z;
  return {.distance = -force * shape * unit + energy * shape_slope,
          .second_angle = 0.5 * energy * (3.0 * az * b_slope.dot(unit) - b_slope.dot(a))};
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
  const mechanics::LinkFrames frames = chain.frames(angles);
  const auto frame = [&](int link) -> const LinkFrame& { return frames[static_cast<std::size_t>(link + 1)]; };
  for (const DistantPair& pair : distant_pairs_) {
    const double strength = pair.sense * (pair.coil < 0 ? 1.0 : currents[pair.coil]) *
                            (pair.second_coil < 0 ? 1.0 : currents[pair.second_coil]);
    if (strength == 0.0) continue;
    const LinkFrame& first = frame(pair.first.link);
    const LinkFrame& second = frame(pair.second.link);
    const Eigen::Vector2d centre = second.at(pair.second.along, pair.second.offset);
    const Eigen::Vector2d between = centre - first.at(pair.first.along, pair.first.offset);
    const EnergySlope slope = energy_slope(pair, between, first, second);
    // Joints below the first body move the pair as one and do no work on it; each other turns the second body.
    for (int j = pair.first.link + 1; j <= pair.second.link; ++j) {
      const Eigen::Vector2d arm = centre - frame(j).joint;
      torques[j] += strength * (arm.y() * slope.distance.x() - arm.x() * slope.distance.y() - slope.second_angle);
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
