#include "magnetics/parallel_cuboids.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <variant>

#include "coilwright/magnetics/constants.hpp"

namespace coilwright::magnetics {
namespace {

// With I(l, m, n) the l-fold integral of 1/r over x, the m-fold one over y and the n-fold one over z, the potential
// energy of two blocks is a sum of second derivatives of I(2, 2, 2) over their 64 pairs of corners, and the force one
// of third derivatives. Of the torque the lever arm x is integrated by parts: x I(1, ..) - I(2, ..) at both ends. I(0,
// 2, 2) and I(1, 1, 2) are those of Newell, Williams and Dunlop (J. Geophys. Res. 98, 9551, 1993), I(-1, 2, 2) that of
// Akoun and Yonnet (IEEE Trans. Magn. 20, 1962, 1984); the others follow by integrating, and from 1/r being harmonic.
// What depends on two coordinates alone drops out of the sum.
constexpr double most_of_rounding = 1e-9;
constexpr double nearest_corners = 1e-12;  // of the size: as of a field's point on a face

class CornerPair {
 public:
  explicit CornerPair(const Eigen::Vector3d& u) : u_(u), r_(u.norm()) {
    for (int i = 0; i < 3; ++i) {
      const double j = u[(i + 1) % 3];
      const double k = u[(i + 2) % 3];
      const double aside = std::hypot(j, k);
      log_[i] = aside > 0.0 ? std::asinh(u[i] / aside) : 0.0;  // its factor is 0 there
      angle_[i] = std::atan(j * k / (u[i] * r_));
    }
  }

  /// Of I(2, 2, 2) by two coordinates.
  [[nodiscard]] double second(int a, int b) const {
    const int c = a == b ? (a + 1) % 3 : 3 - a - b;
    return a == b ? newell_f(a, c, 3 - a - c) : newell_g(a, b, c);
  }

  /// Of I(2, 2, 2) by three coordinates.
  [[nodiscard]] double third(int a, int b, int c) const {
    if (a == b && b == c) return thrice(a);
    if (a == b) return twice(a, c);
    if (a == c) return twice(a, b);
    if (b == c) return twice(b, a);
    return u_[0] * u_[1] * log_[2] + u_[1] * u_[2] * log_[0] + u_[2] * u_[0] * log_[1] -
           0.5 * (u_[0] * u_[0] * angle_[0] + u_[1] * u_[1] * angle_[1] + u_[2] * u_[2] * angle_[2]);
  }

  /// The integral over coordinate `along` of third(a, b, c).
  [[nodiscard]] double third_integrated(int along, int a, int b, int c) const {
    if (a == along) return second(b, c);
    if (b == along) return second(a, c);
    if (c == along) return second(a, b);
    const int sum = a + b + c;
    const int one = (along + 1) % 3;
    const int other = (along + 2) % 3;
    if (sum == 3 * one) return thrice_integrated(one, along);
    if (sum == 3 * other) return thrice_integrated(other, along);
    // I(3, 0, 1): none over what stands twice.
    return sum == 2 * one + other ? integrated(along, one, other) : integrated(along, other, one);
  }

 private:
  // I(0, 2, 2), none over i.
  [[nodiscard]] double newell_f(int i, int j, int k) const {
    const double x = u_[i];
    const double y = u_[j];
    const double z = u_[k];
    return 0.5 * y * (z * z - x * x) * log_[j] + 0.5 * z * (y * y - x * x) * log_[k] - x * y * z * angle_[i] +
           (2.0 * x * x - y * y - z * z) * r_ / 6.0;
  }

  // I(1, 1, 2), two over k.
  [[nodiscard]] double newell_g(int i, int j, int k) const {
    const double x = u_[i];
    const double y = u_[j];
    const double z = u_[k];
    return x * y * z * log_[k] + y * (3.0 * z * z - y * y) / 6.0 * log_[i] + x * (3.0 * z * z - x * x) / 6.0 * log_[j] -
           z * (z * z / 6.0 * angle_[k] + y * y / 2.0 * angle_[j] + x * x / 2.0 * angle_[i]) - x * y * r_ / 3.0;
  }

  // I(-1, 2, 2), by i three times.
  [[nodiscard]] double thrice(int i) const {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    return u_[i] * (r_ - u_[j] * log_[j] - u_[k] * log_[k]) - u_[j] * u_[k] * angle_[i];
  }

  // I(0, 1, 2), by i twice and by j once.
  [[nodiscard]] double twice(int i, int j) const {
    const int k = 3 - i - j;
    const double x = u_[i];
    const double z = u_[k];
    return 0.5 * (z * z - x * x) * log_[j] + u_[j] * z * log_[k] - x * z * angle_[i] - 0.5 * u_[j] * r_;
  }

  // I(-1, 3, 2), the integral of thrice(i) over j, on its branch of the arc tangent.
  [[nodiscard]] double thrice_integrated(int i, int j) const {
    const double x = u_[i];
    const double y = u_[j];
    const double z = u_[3 - i - j];
    return 0.5 * z * (x * x - y * y) * angle_[i] + 0.25 * x * (x * x - 2.0 * y * y - z * z) * log_[j] -
           x * y * z * log_[3 - i - j] + 0.75 * x * y * r_;
  }

  // I(3, 0, 1), three over i, none over j.
  [[nodiscard]] double integrated(int i, int j, int k) const {
    const double x = u_[i];
    const double y = u_[j];
    const double z = u_[k];
    return x * (x * x / 6.0 - y * y / 2.0) * log_[k] + z * (x * x / 2.0 - y * y / 4.0 - z * z / 12.0) * log_[i] +
           y * (y * y / 6.0 - x * x / 2.0) * angle_[j] - 5.0 / 12.0 * x * z * r_;
  }

  Eigen::Vector3d u_;
  double r_;
  std::array<double, 3> log_{};
  std::array<double, 3> angle_{};
};

/// A block in the axes of another, to which its own are parallel.
struct ParallelBlock {
  Eigen::Vector3d half;
  Eigen::Vector3d polarisation;
};

std::optional<ParallelBlock> parallel_block(const Body& body, const Eigen::Matrix3d& axes) {
  const auto* magnet = std::get_if<Magnet>(&body.part);
  const auto* cuboid = magnet == nullptr ? nullptr : std::get_if<Cuboid>(&magnet->shape);
  const bool is_parallel = ((axes.cwiseAbs().array() - 0.5).abs() - 0.5).abs().maxCoeff() < 1e-14;
  if (cuboid == nullptr || !is_parallel) return std::nullopt;
  return ParallelBlock{.half = axes.cwiseAbs() * (0.5 * cuboid->size), .polarisation = axes * polarisation_of(*magnet)};
}

}  // namespace

std::optional<EstimatedWrench> wrench_of_parallel_cuboids(const Body& source, const Body& body) {
  const Pose pose = seen_from(source.pose, body.pose);
  const std::optional<ParallelBlock> from = parallel_block(source, Eigen::Matrix3d::Identity());
  const std::optional<ParallelBlock> on = parallel_block(body, rotation_of(pose));
  if (!from || !on) return std::nullopt;
  const Eigen::Vector3d& at = pose.position;
  const double least = nearest_corners * (from->half + on->half).norm();

  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  double largest = 0.0;  // of what is added up to a force
  for (int corner = 0; corner < 64; ++corner) {
    Eigen::Vector3d end;  // of the second block, from its centre
    Eigen::Vector3d arm;
    double sign = 1.0;
    for (int i = 0; i < 3; ++i) {
      const double s = (corner >> i) % 2 == 0 ? -1.0 : 1.0;
      const double t = (corner >> (i + 3)) % 2 == 0 ? -1.0 : 1.0;
      sign *= s * t;
      end[i] = s * on->half[i];
      arm[i] = at[i] + end[i] + t * from->half[i];
      if (std::abs(arm[i]) < least) arm[i] = std::copysign(least, at[i]);
    }
    const CornerPair term(arm);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const double weight = sign * from->polarisation[a] * on->polarisation[b];
        if (weight == 0.0) continue;
        for (int k = 0; k < 3; ++k) {
          const double part = weight * term.third(a, b, k);
          force[k] += part;
          largest = std::max(largest, std::abs(part));
          // What the field does to the direction of b, and what it does at the lever arm j.
          const int i = (k + 1) % 3;
          const int j = (k + 2) % 3;
          if (b == j) torque[i] += weight * term.second(a, k);
          if (b == i) torque[j] -= weight * term.second(a, k);
          torque[i] += end[j] * part - weight * term.third_integrated(j, a, b, k);
          torque[j] -= end[i] * part - weight * term.third_integrated(i, a, b, k);
        }
      }
  }
  const double scale = 1.0 / (4.0 * std::numbers::pi * vacuum_permeability);
  const double error = 64.0 * std::numeric_limits<double>::epsilon() * largest * scale;
  if (!(error < most_of_rounding * scale * force.norm())) return std::nullopt;
  const Eigen::Matrix3d axes = rotation_of(source.pose);
  return EstimatedWrench{.wrench = {.force = scale * (axes * force), .torque = scale * (axes * torque)},
                         .error = error};
}

}  // namespace coilwright::magnetics
