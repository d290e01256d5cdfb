#include "coilwright/actuator/parts/magnetic_stage.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace coilwright::actuator {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;
using mechanics::LinkFrame;
using mechanics::PlanarChain;

double strength_of(const DistantPair& pair, const CoilCurrents& currents) {
  return pair.sense * (pair.coil < 0 ? 1.0 : currents[pair.coil]) *
         (pair.second_coil < 0 ? 1.0 : currents[pair.second_coil]);
}

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

// Second derivatives of U by the distance vector and the angle of the second body, the first body held; (3, 3),
// symmetric.
Eigen::Matrix3d energy_curvature(const DistantPair& pair, const Eigen::Vector2d& between, const LinkFrame& first,
                                 const LinkFrame& second) {
  const double z = between.norm();
  const Eigen::Vector2d unit = between / z;
  const magnetics::Curve::Sample force = pair.axial_force->sample(z);
  const Eigen::Matrix2d along = unit * unit.transpose();
  const Eigen::Matrix2d across = Eigen::Matrix2d::Identity() - along;
  Eigen::Matrix3d out = Eigen::Matrix3d::Zero();
  if (pair.orientation == DistantPair::Orientation::ignored) {
    out.topLeftCorner<2, 2>() = -force.derivative * along - force.value / z * across;
    return out;
  }
  // U = W(z) S with S = (3 (a.u)(b.u) - a.b) / 2 of the unit vector u, as in energy_slope; b' is b turned.
  const double energy = pair.axial_energy->value(z);
  const Eigen::Vector2d a = first.axis();
  const Eigen::Vector2d b = second.axis();
  const Eigen::Vector2d turned(second.cosine, second.sine);
  const double az = a.dot(unit);
  const auto shape = [&](const Eigen::Vector2d& axis) { return 0.5 * (3.0 * az * axis.dot(unit) - a.dot(axis)); };
  const auto shape_slope = [&](const Eigen::Vector2d& axis) -> Eigen::Vector2d {
    const double bz = axis.dot(unit);
    return 1.5 / z * (bz * (a - az * unit) + az * (axis - bz * unit));
  };
  const double bz = b.dot(unit);
  const Eigen::Vector2d mixed = bz * a + az * b;
  const Eigen::Matrix2d shape_curvature =
      1.5 / (z * z) *
      (a * b.transpose() + b * a.transpose() - 2.0 * (mixed * unit.transpose() + unit * mixed.transpose()) +
       az * bz * (8.0 * along - 2.0 * Eigen::Matrix2d::Identity()));
  const Eigen::Vector2d slope = shape_slope(b);
  out.topLeftCorner<2, 2>() = -force.derivative * shape(b) * along -
                              force.value * (slope * unit.transpose() + unit * slope.transpose()) -
                              force.value * shape(b) / z * across + energy * shape_curvature;
  out.topRightCorner<2, 1>() = -force.value * shape(turned) * unit + energy * shape_slope(turned);
  out.bottomLeftCorner<1, 2>() = out.topRightCorner<2, 1>().transpose();
  out(2, 2) = -energy * shape(b);
  return out;
}

const LinkFrame& frame_of(const mechanics::LinkFrames& frames, int link) {
  const int index = link + 1;  // the base comes first
  return frames[static_cast<std::size_t>(index)];
}

// Where the bodies of a pair are: their links, the centre of the second, and the way to it from the first.
struct PlacedPair {
  const LinkFrame& first;
  const LinkFrame& second;
  Eigen::Vector2d centre;
  Eigen::Vector2d between;
};

PlacedPair placed(const DistantPair& pair, const mechanics::LinkFrames& frames) {
  const LinkFrame& first = frame_of(frames, pair.first.link);
  const LinkFrame& second = frame_of(frames, pair.second.link);
  const Eigen::Vector2d centre = second.at(pair.second.along, pair.second.offset);
  const Eigen::Vector2d between = centre - first.at(pair.first.along, pair.first.offset);
  return {.first = first, .second = second, .centre = centre, .between = between};
}

}  // namespace

MagneticStage::MagneticStage(std::vector<HingePair> hinge_pairs, std::vector<DistantPair> distant_pairs)
    : hinge_pairs_(std::move(hinge_pairs)), distant_pairs_(std::move(distant_pairs)) {}

MagneticStage MagneticStage::with_magnet_strengths(std::span<const double> strengths) const {
  const auto strength = [&](int magnet) { return magnet < 0 ? 1.0 : strengths[static_cast<std::size_t>(magnet)]; };
  MagneticStage out = *this;
  for (HingePair& pair : out.hinge_pairs_) pair.sense *= strength(pair.magnet);
  for (DistantPair& pair : out.distant_pairs_) pair.sense *= strength(pair.magnet) * strength(pair.second_magnet);
  return out;
}

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
  for (const DistantPair& pair : distant_pairs_) {
    const double strength = strength_of(pair, currents);
    if (strength == 0.0) continue;
    const auto [first, second, centre, between] = placed(pair, frames);
    const EnergySlope slope = energy_slope(pair, between, first, second);
    // Joints below the first body move the pair as one and do no work on it; each other turns the second body.
    for (int j = pair.first.link + 1; j <= pair.second.link; ++j) {
      const Eigen::Vector2d arm = centre - frame_of(frames, j).joint;
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
  if (!distant_pairs_.empty()) add_distant_stiffness(chain, angles, currents, stiffness);
}

// The second derivative of a pair's energy by two of the joints between its bodies. Each turns the second body about
// itself, so that its centre moves across the arm from that joint; turning by both takes it towards the outer one.
void MagneticStage::add_distant_stiffness(const PlanarChain& chain, const JointVector& angles,
                                          const CoilCurrents& currents, JointMatrix& stiffness) const {
  const mechanics::LinkFrames frames = chain.frames(angles);
  for (const DistantPair& pair : distant_pairs_) {
    const double strength = strength_of(pair, currents);
    if (strength == 0.0) continue;
    const auto [first, second, centre, between] = placed(pair, frames);
    const Eigen::Vector2d slope = energy_slope(pair, between, first, second).distance;
    const Eigen::Matrix3d curvature = energy_curvature(pair, between, first, second);
    for (int k = pair.first.link + 1; k <= pair.second.link; ++k) {
      const Eigen::Vector2d outer = centre - frame_of(frames, k).joint;
      const Eigen::Vector3d pulled = curvature * Eigen::Vector3d(-outer.y(), outer.x(), 1.0);
      const double turned = slope.dot(outer);
      for (int j = pair.first.link + 1; j <= k; ++j) {
        const Eigen::Vector2d inner = centre - frame_of(frames, j).joint;
        const double by_both = strength * (inner.x() * pulled.y() - inner.y() * pulled.x() + pulled.z() - turned);
        stiffness(j, k) += by_both;
        if (j != k) stiffness(k, j) += by_both;
      }
    }
  }
}

}  // namespace coilwright::actuator
