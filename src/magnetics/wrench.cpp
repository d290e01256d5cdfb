#include "coilwright/magnetics/wrench.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/magnetics/constants.hpp"
#include "magnetics/gauss_legendre.hpp"
#include "magnetics/require.hpp"
#include "magnetics/sheet_kernels.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {
namespace {

Wrench wrench_on_sheet(const SheetBody& source, double radius, double half_length, const Pose& pose) {
  constexpr int angles = 128;
  const QuadratureRule along = gauss_legendre(24);
  const Eigen::Vector3d n = pose.axis.normalized();
  const Eigen::Vector3d e1 = n.unitOrthogonal();
  const Eigen::Vector3d e2 = n.cross(e1);
  Wrench total;
  std::array<double, angles> rho;
  std::array<double, angles> height;
  std::array<double, angles> radial;
  std::array<double, angles> axial;
  std::array<Eigen::Vector3d, angles> arm;
  for (std::size_t i = 0; i < along.count; ++i) {
    std::array<double, angles> sum_radial{};
    std::array<double, angles> sum_axial{};
    double near = 1e300;
    for (int j = 0; j < angles; ++j) {
      const double phi = 2.0 * std::numbers::pi * (j + 0.5) / angles;
      arm[j] = radius * (std::cos(phi) * e1 + std::sin(phi) * e2) + half_length * along.node[i] * n;
      const Eigen::Vector3d p = pose.position + arm[j];
      rho[j] = std::hypot(p.x(), p.y());
      height[j] = p.z();
      const double r = std::clamp(rho[j], source.inner_radius, source.outer_radius);
      near = std::min(near, std::hypot(rho[j] - r, std::abs(height[j]) - source.half_length));
    }
    const double far = source.outer_radius + pose.position.norm() + radius + half_length + source.half_length;
    const int steps = landen_steps_needed(near * near, far * far);
    const RadialNodes nodes{gauss_legendre(64), source.mean_radius(), source.half_width()};
    if (source.spread == Spread::uniform) {
      field_of_sheets(nodes, source.half_length, steps, {rho, height}, {radial, axial});
      sum_radial = radial;
      sum_axial = axial;
    } else {
      const std::array<double, 8> weight{1.0};
      for (int shell = 0; shell < source.shells; ++shell) {
        const std::array<double, 8> node{source.shells == 1 ? 0.0 : -1.0 + 2.0 * shell / (source.shells - 1)};
        const RadialNodes one{{node.data(), weight.data(), 1, 8}, source.mean_radius(), source.half_width()};
        field_of_sheets(one, source.half_length, steps, {rho, height}, {radial, axial});
        for (int j = 0; j < angles; ++j) {
          sum_radial[j] += radial[j] / source.shells;
          sum_axial[j] += axial[j] / source.shells;
        }
      }
    }
    for (int j = 0; j < angles; ++j) {
      const Eigen::Vector3d p = pose.position + arm[j];
      const double over = rho[j] > 0.0 ? sum_radial[j] / rho[j] : 0.0;
      const Eigen::Vector3d field(p.x() * over, p.y() * over, sum_axial[j]);
      const Eigen::Vector3d rim = arm[j] - arm[j].dot(n) * n;
      const Eigen::Vector3d tangent = n.cross(rim) / radius;
      const double weight = along.weight[i] / angles;
      total.force += weight * tangent.cross(field);
      total.torque += weight * tangent * arm[j].dot(field);
    }
  }
  const double area = 4.0 * std::numbers::pi * radius * half_length;
  total.force *= area;
  total.torque *= area;
  return total;
}

Wrench wrench_between(const SheetBody& first, const SheetBody& second, const Pose& pose) {
  require(pose.position.allFinite(), "pose position", "finite", pose.position.norm());
  require(pose.axis.allFinite() && pose.axis.norm() > 0.0, "pose axis", "finite and not zero", pose.axis.norm());
  Wrench total;
  const bool uniform = second.spread == Spread::uniform;
  const QuadratureRule rule = gauss_legendre(16);
  const int sheets = uniform ? static_cast<int>(rule.count) : second.shells;
  for (int i = 0; i < sheets; ++i) {
    const double x = uniform ? rule.node[i] : (sheets == 1 ? 0.0 : -1.0 + 2.0 * i / (sheets - 1));
    const double weight = uniform ? rule.weight[i] : 1.0 / sheets;
    const Wrench part =
        wrench_on_sheet(first, second.mean_radius() + second.half_width() * x, second.half_length, pose);
    total.force += weight * part.force;
    total.torque += weight * part.torque;
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
