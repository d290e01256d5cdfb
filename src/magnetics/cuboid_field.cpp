#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/magnet_field.hpp"

namespace coilwright::magnetics {
namespace {

// H = T M as in round_field.cpp. T of a block is a sum over its eight corners, seen from which the point is at
// (x, y, z), r away (Yang and others, Supercond. Sci. Technol. 3, 591, 1990; Camacho and Sosa, Rev. Mex. Fis. E 59, 8,
// 2013): T_xx = 1/(4 pi) sum +- atan(y z / (x r)), T_xy = -1/(4 pi) sum +- ln(z + r), and so on round. The sign is that
// of the product of the three ends.

constexpr double cuboid_surface = 1e-12;  // of the size: nearer to a face than that is just outside

/// Farther than this many half diagonals the corners' sum loses more digits than dipoles spread over the volume.
constexpr double far = 20.0;
constexpr int far_order = 4;

Eigen::Vector3d put_outside(const Eigen::Vector3d& half, const Eigen::Vector3d& point) {
  const double least = cuboid_surface * half.norm();
  Eigen::Vector3d out = point;
  const bool beside = ((point.cwiseAbs() - half).array() <= least).all();
  for (int i = 0; i < 3; ++i)
    if (beside && std::abs(std::abs(point[i]) - half[i]) <= least) out[i] = std::copysign(half[i] + least, point[i]);
  return out;
}

// asinh(z / h), which differs from ln(z + r) by what cancels between two corners on one edge.
double logarithm(double z, double h) {
  return std::asinh(z / h);
}

class Corners {
 public:
  Corners(const Eigen::Vector3d& half, const Eigen::Vector3d& point) {
    // On the line of an edge the two logarithms of its corners are infinite and cancel, unless it is on the edge.
    const double least = 1e-150 * half.norm();
    for (int corner = 0; corner < 8; ++corner) {
      double sign = -1.0 / (4.0 * std::numbers::pi);
      for (int i = 0; i < 3; ++i) {
        const double end = (corner >> i) % 2 == 0 ? -1.0 : 1.0;
        sign *= end;
        arm_[i] = point[i] - end * half[i];
        if (std::abs(arm_[i]) < least) arm_[i] = least;
      }
      add(sign);
    }
  }

  [[nodiscard]] const Eigen::Matrix3d& tensor() const noexcept { return tensor_; }
  /// Element i: the derivative of the tensor by coordinate i.
  [[nodiscard]] const std::array<Eigen::Matrix3d, 3>& slopes() const noexcept { return slopes_; }

 private:
  void add(double sign) {
    const double r = arm_.norm();
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double x = arm_[i];
      const double y = arm_[j];
      const double z = arm_[k];
      const double xy = x * x + y * y;
      const double xz = x * x + z * z;
      tensor_(i, i) -= sign * std::atan(y * z / (x * r));
      const double across = sign * logarithm(z, std::sqrt(xy));
      tensor_(i, j) += across;
      tensor_(j, i) += across;
      // d/dx atan(y z / (x r)) = -y z (x^2 + r^2) / (r (x^2 + y^2) (x^2 + z^2)), d/dy of it = x z / (r (x^2 + y^2)).
      slopes_[i](i, i) += sign * y * z * (x * x + r * r) / (r * xy * xz);
      const double aside = -sign * x * z / (r * xy);
      const double above = -sign * x * y / (r * xz);
      set(i, i, j, aside);
      set(i, i, k, above);
      // Of the logarithm along z; once for three.
      if (i == 0) {
        const double all = sign / r;
        slopes_[0](1, 2) += all;
        slopes_[0](2, 1) += all;
        slopes_[1](0, 2) += all;
        slopes_[1](2, 0) += all;
        slopes_[2](0, 1) += all;
        slopes_[2](1, 0) += all;
      }
    }
  }

  // The third derivatives are alike in every order.
  void set(int i, int same, int other, double value) {
    slopes_[other](i, same) += value;
    slopes_[i](same, other) += value;
    slopes_[i](other, same) += value;
  }

  Eigen::Vector3d arm_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d tensor_ = Eigen::Matrix3d::Zero();
  std::array<Eigen::Matrix3d, 3> slopes_{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
};

// H of a dipole of unit volume and magnetisation m, and its gradient.
void add_dipole(const Eigen::Vector3d& arm, const Eigen::Vector3d& m, double weight, FieldSample& sample) {
  const double r = arm.norm();
  const Eigen::Vector3d u = arm / r;
  const double along = m.dot(u);
  const double scale = weight / (4.0 * std::numbers::pi * r * r * r);
  sample.flux_density += scale * (3.0 * along * u - m);
  sample.gradient +=
      3.0 * scale / r *
      (u * m.transpose() + m * u.transpose() + along * Eigen::Matrix3d::Identity() - 5.0 * along * u * u.transpose());
}

FieldSample far_field(const Eigen::Vector3d& half, const Eigen::Vector3d& m, const Eigen::Vector3d& point) {
  FieldSample sample;
  const QuadratureRule rule = gauss_legendre(far_order);
  const double volume = 8.0 * half.prod();
  for (std::size_t i = 0; i < rule.count; ++i)
    for (std::size_t j = 0; j < rule.count; ++j)
      for (std::size_t k = 0; k < rule.count; ++k) {
        const Eigen::Vector3d place(rule.node[i], rule.node[j], rule.node[k]);
        add_dipole(point - half.cwiseProduct(place), m, volume * rule.weight[i] * rule.weight[j] * rule.weight[k],
                   sample);
      }
  return sample;
}

}  // namespace

void add_cuboid_field(const Cuboid& cuboid, const Eigen::Vector3d& polarisation, Wanted wanted,
                      std::span<const Eigen::Vector3d> points, std::span<FieldSample> samples) {
  const Eigen::Vector3d half = 0.5 * cuboid.size;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Eigen::Vector3d point = put_outside(half, points[n]);
    if (point.norm() > far * half.norm()) {
      const FieldSample sample = far_field(half, polarisation, point);
      samples[n].flux_density += sample.flux_density;
      samples[n].gradient += sample.gradient;
      continue;
    }
    const Corners corners(half, point);
    samples[n].flux_density += corners.tensor() * polarisation;
    if ((point.cwiseAbs().array() < half.array()).all()) samples[n].flux_density += polarisation;
    if (wanted == Wanted::gradient)
      for (int i = 0; i < 3; ++i) samples[n].gradient.col(i) += corners.slopes()[i] * polarisation;
  }
}

}  // namespace coilwright::magnetics
