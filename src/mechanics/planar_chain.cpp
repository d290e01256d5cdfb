#include "coilwright/mechanics/planar_chain.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>

#include "coilwright/mechanics/ldlt.hpp"
#include "mechanics/add_rotors.hpp"
#include "mechanics/check_link.hpp"

namespace coilwright::mechanics {
// The equations are written in absolute angles phi_j = theta_0 + ... + theta_j, where every coefficient depends on one
// difference phi_k - phi_j only; joint quantities follow by the chain rule.
struct PlanarChain::Directions {
  std::array<double, max_joints> sine;
  std::array<double, max_joints> cosine;

  // sin and cos of phi_k - phi_j.
  [[nodiscard]] double sine_between(int j, int k) const { return sine[k] * cosine[j] - cosine[k] * sine[j]; }
  [[nodiscard]] double cosine_between(int j, int k) const { return cosine[k] * cosine[j] + sine[k] * sine[j]; }
};

namespace {

// A torque at joint j acts on phi_j and reacts on phi_{j-1}: dV/dtheta_j is the sum of dV/dphi_k over k >= j.
void absolute_to_joint(JointVector& torques) {
  for (int j = static_cast<int>(torques.size()) - 2; j >= 0; --j) torques[j] += torques[j + 1];
}

}  // namespace

PlanarChain::PlanarChain(std::span<const Link> links, double gravity, double base_tilt)
    : joints_(static_cast<int>(links.size())), gravity_(gravity), base_tilt_(base_tilt) {
  if (links.empty() || links.size() > max_joints)
    throw std::invalid_argument(fmt::format("links: 1 to {} are supported; got {}", max_joints, links.size()));
  if (!std::isfinite(gravity) || gravity < 0.0)
    throw std::invalid_argument(fmt::format("gravity must be finite and >= 0; got {}", gravity));
  if (!std::isfinite(base_tilt))
    throw std::invalid_argument(fmt::format("base_tilt must be finite; got {}", base_tilt));
  for (int i = 0; i < joints_; ++i) {
    check_link(links[i], i);
    links_[i] = links[i];
  }
  double outboard = 0.0;
  for (int i = joints_ - 1; i >= 0; --i) {
    outboard_mass_[i] = outboard;
    along_moment_[i] = links_[i].length * outboard + links_[i].mass * links_[i].com_along;
    offset_moment_[i] = links_[i].mass * links_[i].com_offset;
    const Link& own = links_[i];
    const double about_joint = own.length * own.length * outboard + own.inertia +
                               own.mass * (own.com_along * own.com_along + own.com_offset * own.com_offset);
    if (!(about_joint > 0.0) || !std::isfinite(about_joint))
      throw std::invalid_argument(
          fmt::format("link {}: must have a finite moment of inertia > 0 about its joint; got {}", i, about_joint));
    outboard += links_[i].mass;
  }
}

PlanarChain PlanarChain::under_gravity(double gravity, double base_tilt) const {
  return PlanarChain(links(), gravity, base_tilt);
}

PlanarChain PlanarChain::with_links(std::span<const Link> links) const {
  return PlanarChain(links, gravity_, base_tilt_);
}

template <int Count>
PlanarChain::Directions PlanarChain::directions(const JointVector& angles, double tilt) const {
  const int n = Count == any_count ? joints_ : Count;
  Directions out;
  double absolute = tilt;
  for (int j = 0; j < n; ++j) {
    absolute += angles[j];
    out.sine[j] = std::sin(absolute);
    out.cosine[j] = std::cos(absolute);
  }
  return out;
}

// For j < k: M_jk = L_j (A_k cos(phi_k - phi_j) + O_k sin(phi_k - phi_j)), A and O the moments of link k. Differences
// only, so a common tilt changes nothing.
template <int Count>
JointMatrix PlanarChain::absolute_mass_matrix(const Directions& d) const {
  const int n = Count == any_count ? joints_ : Count;
  JointMatrix mass(n, n);
  for (int k = 0; k < n; ++k) {
    const Link& own = links_[k];
    mass(k, k) = own.length * own.length * outboard_mass_[k] +
                 own.mass * (own.com_along * own.com_along + own.com_offset * own.com_offset) + own.inertia;
    for (int j = 0; j < k; ++j) {
      mass(j, k) = mass(k, j) =
          links_[j].length * (along_moment_[k] * d.cosine_between(j, k) + offset_moment_[k] * d.sine_between(j, k));
    }
  }
  add_rotors(links(), mass);
  return mass;
}

// c_j = sum_k dM_jk/dphi_k phi_k'^2: no cross terms in absolute angles.
template <int Count>
JointVector PlanarChain::absolute_velocity_torques(const Directions& d, const JointVector& rates) const {
  const int n = Count == any_count ? joints_ : Count;
  JointVector torques = JointVector::Zero(n);
  std::array<double, max_joints> squared_rate;
  double absolute_rate = 0.0;
  for (int j = 0; j < n; ++j) {
    absolute_rate += rates[j];
    squared_rate[j] = absolute_rate * absolute_rate;
  }
  for (int k = 1; k < n; ++k) {
    for (int j = 0; j < k; ++j) {
      const double slope =
          links_[j].length * (offset_moment_[k] * d.cosine_between(j, k) - along_moment_[k] * d.sine_between(j, k));
      torques[j] += slope * squared_rate[k];
      torques[k] -= slope * squared_rate[j];
    }
  }
  return torques;
}

// dV/dphi_j = g (A_j sin(phi_j + tilt) - O_j cos(phi_j + tilt)).
template <int Count>
JointVector PlanarChain::absolute_gravity_torques(const Directions& tilted) const {
  const int n = Count == any_count ? joints_ : Count;
  JointVector torques(n);
  for (int j = 0; j < n; ++j)
    torques[j] = gravity_ * (along_moment_[j] * tilted.sine[j] - offset_moment_[j] * tilted.cosine[j]);
  return torques;
}

JointMatrix PlanarChain::mass_matrix(const JointVector& angles) const {
  JointMatrix mass = absolute_mass_matrix(directions(angles, 0.0));
  // phi = T theta with T lower triangular of ones, so M_theta = T^T M_phi T: suffix sums over rows, then columns.
  for (int j = joints_ - 2; j >= 0; --j) mass.row(j) += mass.row(j + 1);
  for (int j = joints_ - 2; j >= 0; --j) mass.col(j) += mass.col(j + 1);
  return mass;
}

JointVector PlanarChain::velocity_torques(const JointVector& angles, const JointVector& rates) const {
  JointVector torques = absolute_velocity_torques(directions(angles, 0.0), rates);
  absolute_to_joint(torques);
  return torques;
}

JointVector PlanarChain::gravity_torques(const JointVector& angles) const {
  JointVector torques = absolute_gravity_torques(directions(angles, base_tilt_));
  absolute_to_joint(torques);
  return torques;
}

JointVector PlanarChain::bias_torques(const JointVector& angles, const JointVector& rates) const {
  // Velocity torques know differences of angles only: those of tilted ones are the same.
  const Directions tilted = directions(angles, base_tilt_);
  JointVector torques = absolute_velocity_torques(tilted, rates) + absolute_gravity_torques(tilted);
  absolute_to_joint(torques);
  return torques;
}

JointMatrix PlanarChain::gravity_stiffness(const JointVector& angles) const {
  // V is a sum of functions of one absolute angle each: d2V/dtheta_i dtheta_j is the suffix sum from max(i, j).
  JointMatrix stiffness(joints_, joints_);
  const Directions tilted = directions(angles, base_tilt_);
  double sum = 0.0;
  for (int j = joints_ - 1; j >= 0; --j) {
    sum += gravity_ * (along_moment_[j] * tilted.cosine[j] + offset_moment_[j] * tilted.sine[j]);
    for (int i = 0; i <= j; ++i) stiffness(i, j) = stiffness(j, i) = sum;
  }
  return stiffness;
}

template <int Count>
JointVector PlanarChain::accelerations_of(const JointVector& angles, const JointVector& rates,
                                          const JointVector& torques) const {
  const int n = Count == any_count ? joints_ : Count;
  // With a tilt, differences of tilted angles are those of untilted ones: one set of sines serves both.
  const Directions tilted = directions<Count>(angles, base_tilt_);
  const JointVector velocity = absolute_velocity_torques<Count>(tilted, rates);
  const JointVector weight = absolute_gravity_torques<Count>(tilted);
  JointVector force(n);
  for (int j = 0; j < n; ++j) force[j] = torques[j] - (j + 1 < n ? torques[j + 1] : 0.0) - velocity[j] - weight[j];
  JointMatrix mass = absolute_mass_matrix<Count>(tilted);
  factorize_ldlt(mass, n);
  solve_lower_ldlt(mass, n, force);
  solve_upper_ldlt(mass, n, force);
  for (int j = n - 1; j > 0; --j) force[j] -= force[j - 1];
  return force;
}

JointVector PlanarChain::accelerations(const JointVector& angles, const JointVector& rates,
                                       const JointVector& torques) const {
  // A, B, C and D have 1, 2, 4 and 5 joints: unrolled, two take half the time.
  switch (joints_) {
    case 1:
      return accelerations_of<1>(angles, rates, torques);
    case 2:
      return accelerations_of<2>(angles, rates, torques);
    case 4:
      return accelerations_of<4>(angles, rates, torques);
    case 5:
      return accelerations_of<5>(angles, rates, torques);
    default:
      return accelerations_of<any_count>(angles, rates, torques);
  }
}

JointVector PlanarChain::joint_mobility() const {
  return mass_matrix(JointVector::Zero(joints_)).llt().solve(JointMatrix::Identity(joints_, joints_)).diagonal();
}

double PlanarChain::kinetic_energy(const JointVector& angles, const JointVector& rates) const {
  return 0.5 * rates.dot(mass_matrix(angles) * rates);
}

double PlanarChain::potential_energy(const JointVector& angles) const {
  const Directions tilted = directions(angles, base_tilt_);
  double energy = 0.0;
  for (int j = 0; j < joints_; ++j)
    energy -= gravity_ * (along_moment_[j] * tilted.cosine[j] + offset_moment_[j] * tilted.sine[j]);
  return energy;
}

Eigen::Vector2d PlanarChain::position(const LinkPoint& point, const JointVector& angles) const {
  const Directions d = directions(angles, 0.0);
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  for (int j = 0; j < point.link; ++j) at += links_[j].length * Eigen::Vector2d(d.sine[j], -d.cosine[j]);
  const double sine = point.link < 0 ? 0.0 : d.sine[point.link];
  const double cosine = point.link < 0 ? 1.0 : d.cosine[point.link];
  return at + point.along * Eigen::Vector2d(sine, -cosine) + point.offset * Eigen::Vector2d(-cosine, -sine);
}

LinkFrames PlanarChain::frames(const JointVector& angles) const {
  LinkFrames out;
  out[0] = {.joint = Eigen::Vector2d::Zero(), .sine = 0.0, .cosine = 1.0};
  double absolute = 0.0;
  Eigen::Vector2d joint = Eigen::Vector2d::Zero();
  for (int j = 0; j < joints_; ++j) {
    absolute += angles[j];
    out[j + 1] = {.joint = joint, .sine = std::sin(absolute), .cosine = std::cos(absolute)};
    joint += links_[j].length * out[j + 1].axis();
  }
  return out;
}

PointJacobian PlanarChain::jacobian(const LinkPoint& point, const JointVector& angles) const {
  PointJacobian slope = PointJacobian::Zero(2, joints_);
  if (point.link < 0) return slope;
  const Directions d = directions(angles, 0.0);
  const double sine = d.sine[point.link];
  const double cosine = d.cosine[point.link];
  slope.col(point.link) = point.along * Eigen::Vector2d(cosine, sine) + point.offset * Eigen::Vector2d(sine, -cosine);
  for (int j = 0; j < point.link; ++j) slope.col(j) = links_[j].length * Eigen::Vector2d(d.cosine[j], d.sine[j]);
  for (int j = point.link - 1; j >= 0; --j) slope.col(j) += slope.col(j + 1);
  return slope;
}

// Every angle turns what lies beyond its joint about that joint: by 90 degrees of the lever, anticlockwise.
PointJacobian PlanarChain::jacobian(const LinkPoint& point, const LinkFrames& frames) const {
  PointJacobian slope = PointJacobian::Zero(2, joints_);
  if (point.link < 0) return slope;
  const Eigen::Vector2d at = frames[static_cast<std::size_t>(point.link) + 1].at(point.along, point.offset);
  for (int j = 0; j <= point.link; ++j) {
    const Eigen::Vector2d lever = at - frames[static_cast<std::size_t>(j) + 1].joint;
    slope.col(j) = Eigen::Vector2d(-lever.y(), lever.x());
  }
  return slope;
}

}  // namespace coilwright::mechanics
