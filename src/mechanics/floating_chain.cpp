#include "coilwright/mechanics/floating_chain.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "mechanics/check_link.hpp"

namespace coilwright::mechanics {

FloatingChain::FloatingChain(std::span<const Link> links, double gravity)
    : count_(static_cast<int>(links.size())), gravity_(gravity) {
  if (links.empty() || links.size() > links_.size())
    throw std::invalid_argument(fmt::format("links: 1 to {} are supported; got {}", links_.size(), links.size()));
  if (!std::isfinite(gravity) || gravity < 0.0)
    throw std::invalid_argument(fmt::format("gravity must be finite and >= 0; got {}", gravity));
  for (int i = 0; i < count_; ++i) {
    check_link(links[i], i);
    links_[i] = links[i];
  }
}

double FloatingChain::mass() const noexcept {
  double sum = 0.0;
  for (int i = 0; i < count_; ++i) sum += links_[i].mass;
  return sum;
}

FloatingFrames FloatingChain::frames(const CoordinateVector& coordinates) const {
  FloatingFrames out;
  Eigen::Vector2d joint(coordinates[0], coordinates[1]);
  double absolute = 0.0;
  for (int i = 0; i < count_; ++i) {
    absolute += coordinates[2 + i];
    out[i] = {.joint = joint, .sine = std::sin(absolute), .cosine = std::cos(absolute)};
    joint += links_[i].length * out[i].axis();
  }
  return out;
}

Eigen::Vector2d FloatingChain::position(const FloatingFrames& frames, const LinkPoint& point) const {
  return frames[point.link].at(point.along, point.offset);
}

// Every angle turns what lies beyond its joint about that joint: by 90 degrees of the lever, anticlockwise.
FloatingJacobian FloatingChain::jacobian(const FloatingFrames& frames, const LinkPoint& point) const {
  FloatingJacobian slope = FloatingJacobian::Zero(2, coordinates());
  slope(0, 0) = slope(1, 1) = 1.0;
  const Eigen::Vector2d at = position(frames, point);
  for (int i = 0; i <= point.link; ++i) {
    const Eigen::Vector2d lever = at - frames[i].joint;
    slope.col(2 + i) = Eigen::Vector2d(-lever.y(), lever.x());
  }
  return slope;
}

CoordinateMatrix FloatingChain::mass_matrix(const FloatingFrames& frames) const {
  const int n = coordinates();
  CoordinateMatrix mass = CoordinateMatrix::Zero(n, n);
  std::array<Eigen::Vector2d, max_coordinates> slopes;  // of a link's centre of mass: the columns of its jacobian()
  slopes[0] = Eigen::Vector2d::UnitX();
  slopes[1] = Eigen::Vector2d::UnitY();
  for (int i = 0; i < count_; ++i) {
    const Eigen::Vector2d at = position(frames, centre(i));
    for (int k = 0; k <= i; ++k) {
      const Eigen::Vector2d lever = at - frames[k].joint;
      slopes[2 + k] = Eigen::Vector2d(-lever.y(), lever.x());
    }
    const int last = 3 + i;  // coordinates beyond it do not move this link
    for (int k = 0; k < last; ++k)
      for (int j = 0; j <= k; ++j)
        mass(j, k) += links_[i].mass * slopes[j].dot(slopes[k]) + (j >= 2 ? links_[i].inertia : 0.0);
  }
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < k; ++j) mass(k, j) = mass(j, k);
  return mass;
}

CoordinateVector FloatingChain::velocity_forces(const FloatingFrames& frames, const CoordinateVector& rates) const {
  return forces_in_lift(frames, rates, 0.0);
}

CoordinateVector FloatingChain::gravity_forces(const FloatingFrames& frames) const {
  return forces_in_lift(frames, CoordinateVector::Zero(coordinates()), gravity_);
}

CoordinateVector FloatingChain::bias_forces(const FloatingFrames& frames, const CoordinateVector& rates) const {
  return forces_in_lift(frames, rates, gravity_);
}

// Accelerations of the centres of mass while no coordinate accelerates: towards the joints, by the squares of the
// absolute rates, and upwards with the lift, in which everything weighs as it does in gravity.
CoordinateVector FloatingChain::forces_in_lift(const FloatingFrames& frames, const CoordinateVector& rates,
                                               double lift) const {
  CoordinateVector force = CoordinateVector::Zero(coordinates());
  Eigen::Vector2d of_joint(0.0, lift);
  double absolute = 0.0;
  for (int i = 0; i < count_; ++i) {
    absolute += rates[2 + i];
    const Eigen::Vector2d at = position(frames, centre(i));
    const Eigen::Vector2d lever = at - frames[i].joint;
    const Eigen::Vector2d needed = links_[i].mass * (of_joint - absolute * absolute * lever);
    // By jacobian(): each angle turns the centre about its joint.
    force.head<2>() += needed;
    for (int k = 0; k <= i; ++k) {
      const Eigen::Vector2d arm = at - frames[k].joint;
      force[2 + k] += arm.x() * needed.y() - arm.y() * needed.x();
    }
    of_joint -= absolute * absolute * links_[i].length * frames[i].axis();
  }
  return force;
}

double FloatingChain::kinetic_energy(const FloatingFrames& frames, const CoordinateVector& rates) const {
  return 0.5 * rates.dot(mass_matrix(frames) * rates);
}

double FloatingChain::potential_energy(const FloatingFrames& frames) const {
  double energy = 0.0;
  for (int i = 0; i < count_; ++i) energy += links_[i].mass * gravity_ * position(frames, centre(i)).y();
  return energy;
}

}  // namespace coilwright::mechanics
