#include <cmath>

#include "coilwright/mechanics/planar_chain.hpp"
#include "mechanics/add_rotors.hpp"

namespace coilwright::mechanics {
namespace {

// One value per link, in absolute angles phi_j = theta_0 + ... + theta_j.
std::array<double, max_joints> absolute(const JointVector& joints) {
  std::array<double, max_joints> out;
  double sum = 0.0;
  for (int j = 0; j < static_cast<int>(joints.size()); ++j) out[j] = sum += joints[j];
  return out;
}

// phi = T theta with T lower triangular of ones, so A_theta = T^T A_phi T: suffix sums over rows, then columns.
void absolute_to_joint(JointMatrix& matrix, int n) {
  for (int k = 0; k < n; ++k)
    for (int j = n - 2; j >= 0; --j) matrix(j, k) += matrix(j + 1, k);
  for (int k = n - 2; k >= 0; --k)
    for (int j = 0; j < n; ++j) matrix(j, k) += matrix(j, k + 1);
}

}  // namespace

// In absolute angles the torque of link j is the sum over the others of M_jk phi_k'' + dM_jk/dphi_k phi_k'^2, where
// M_jk depends on phi_k - phi_j alone, and as A cos + B sin of it: the second slope of M_jk is -M_jk.
ChainSlopes PlanarChain::slopes(const JointVector& angles, const JointVector& rates,
                                const JointVector& accelerations) const {
  const int n = joints_;
  const std::array<double, max_joints> direction = absolute(angles);
  const std::array<double, max_joints> rate = absolute(rates);
  const std::array<double, max_joints> acceleration = absolute(accelerations);
  std::array<double, max_joints> sine;
  std::array<double, max_joints> cosine;
  for (int j = 0; j < n; ++j) {
    sine[j] = std::sin(direction[j] + base_tilt_);
    cosine[j] = std::cos(direction[j] + base_tilt_);
  }
  ChainSlopes out{JointMatrix(n, n), JointMatrix::Zero(n, n), JointMatrix::Zero(n, n)};
  JointMatrix& mass = out.by_acceleration;
  for (int k = 0; k < n; ++k) {
    const Link& own = links_[k];
    mass(k, k) = own.length * own.length * outboard_mass_[k] +
                 own.mass * (own.com_along * own.com_along + own.com_offset * own.com_offset) + own.inertia;
    out.by_angle(k, k) += gravity_ * (along_moment_[k] * cosine[k] + offset_moment_[k] * sine[k]);
    for (int j = 0; j < k; ++j) {
      const double sine_between = sine[k] * cosine[j] - cosine[k] * sine[j];
      const double cosine_between = cosine[k] * cosine[j] + sine[k] * sine[j];
      const double coupling = links_[j].length * (along_moment_[k] * cosine_between + offset_moment_[k] * sine_between);
      const double slope = links_[j].length * (offset_moment_[k] * cosine_between - along_moment_[k] * sine_between);
      mass(j, k) = mass(k, j) = coupling;
      out.by_rate(j, k) = 2.0 * slope * rate[k];
      out.by_rate(k, j) = -2.0 * slope * rate[j];
      const double near = slope * acceleration[k] - coupling * rate[k] * rate[k];
      const double far = slope * acceleration[j] + coupling * rate[j] * rate[j];
      out.by_angle(j, k) += near;
      out.by_angle(j, j) -= near;
      out.by_angle(k, k) += far;
      out.by_angle(k, j) -= far;
    }
  }
  add_rotors(links(), mass);
  absolute_to_joint(out.by_acceleration, n);
  absolute_to_joint(out.by_rate, n);
  absolute_to_joint(out.by_angle, n);
  return out;
}

}  // namespace coilwright::mechanics
