#include "coilwright/magnetics/body.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/inner_field.hpp"
#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

void check_shape(const Ring& ring) {
  require(std::isfinite(ring.inner_radius) && ring.inner_radius >= 0.0, "inner radius", "finite and >= 0",
          ring.inner_radius);
  require(std::isfinite(ring.outer_radius) && ring.outer_radius > ring.inner_radius, "outer radius",
          "finite and beyond the inner radius", ring.outer_radius);
  require_positive("length", ring.length);
}

void check_shape(const Cuboid& cuboid) {
  for (const double side : cuboid.size) require_positive("side", side);
}

void check_part(const DrivenCoil& coil) {
  require_finite("current", coil.current);
}

void check_part(const Magnet& magnet) {
  std::visit([](const auto& shape) { check_shape(shape); }, magnet.shape);
  require(magnet.remanence.allFinite(), "remanence", "finite", magnet.remanence.norm());
  const double recoil = magnet.recoil_permeability;
  require(recoil >= 1.0 && recoil <= CylinderMagnet::most_recoil_permeability, "recoil permeability",
          fmt::format("from 1 to {}", CylinderMagnet::most_recoil_permeability), recoil);
}

Eigen::Vector3d round_factors(double along) {
  return {0.5 * (1.0 - along), 0.5 * (1.0 - along), along};
}

// The mean over the ring of the field of the full cylinder less that of the bore, both magnetised along the axis: the
// mean over the bore of the cylinder's field is that over the cylinder of the bore's, by reciprocity, per volume.
Eigen::Vector3d factors_of(const Ring& ring) {
  const CylinderSize outer{.radius = ring.outer_radius, .length = ring.length};
  const double full = demagnetisation_factor(outer);
  if (ring.inner_radius == 0.0) return round_factors(full);
  const CylinderSize bore{.radius = ring.inner_radius, .length = ring.length};
  const CylinderMagnet unit({.radius = outer.radius, .length = outer.length, .remanence = vacuum_permeability});
  const double mutual = 1.0 - axial_field(unit, bore, 0.0).mean;
  const double share = (bore.radius / outer.radius) * (bore.radius / outer.radius);
  return round_factors((full + share * demagnetisation_factor(bore) - 2.0 * share * mutual) / (1.0 - share));
}

// Aharoni's (1), along c of a block of 2a by 2b by 2c, which needs no unit: here of full sides.
double factor_along(double a, double b, double c) {
  const double ab = std::hypot(a, b);
  const double bc = std::hypot(b, c);
  const double ca = std::hypot(c, a);
  const double abc = std::hypot(a, b, c);
  // ln((p - q) / (p + q)) without cancellation.
  const auto logarithm = [](double p, double q) { return -2.0 * std::atanh(q / p); };
  const double sum = (b * b - c * c) / (2.0 * b * c) * logarithm(abc, a) +
                     (a * a - c * c) / (2.0 * a * c) * logarithm(abc, b) - b / (2.0 * c) * logarithm(ab, a) -
                     a / (2.0 * c) * logarithm(ab, b) + c / (2.0 * a) * logarithm(bc, b) +
                     c / (2.0 * b) * logarithm(ca, a) + 2.0 * std::atan(a * b / (c * abc)) +
                     (a * a * a + b * b * b - 2.0 * c * c * c) / (3.0 * a * b * c) +
                     (a * a + b * b - 2.0 * c * c) / (3.0 * a * b * c) * abc + c / (a * b) * (ca + bc) -
                     (ab * ab * ab + bc * bc * bc + ca * ca * ca) / (3.0 * a * b * c);
  return sum / std::numbers::pi;
}

Eigen::Vector3d factors_of(const Cuboid& cuboid) {
  const auto& [x, y, z] = std::array{cuboid.size.x(), cuboid.size.y(), cuboid.size.z()};
  return {factor_along(y, z, x), factor_along(z, x, y), factor_along(x, y, z)};
}

double half_extent_of(const Ring& ring, const Eigen::Vector3d& direction) {
  return 0.5 * ring.length * std::abs(direction.z()) + ring.outer_radius * std::hypot(direction.x(), direction.y());
}

double half_extent_of(const Cuboid& cuboid, const Eigen::Vector3d& direction) {
  return 0.5 * cuboid.size.dot(direction.cwiseAbs());
}

}  // namespace

Magnet magnet_of(const CylinderMagnet& magnet) {
  return {.shape = Ring{.inner_radius = 0.0, .outer_radius = magnet.radius(), .length = magnet.length()},
          .remanence = {0.0, 0.0, magnet.remanence()},
          .recoil_permeability = magnet.recoil_permeability()};
}

void check(const Body& body) {
  std::visit([](const auto& part) { check_part(part); }, body.part);
  (void)rotation_of(body.pose);
}

Shape shape_of(const Body& body) {
  if (const auto* magnet = std::get_if<Magnet>(&body.part)) return magnet->shape;
  const ThickCoil& coil = std::get<DrivenCoil>(body.part).coil;
  return Ring{.inner_radius = coil.inner_radius(), .outer_radius = coil.outer_radius(), .length = coil.length()};
}

double half_extent(const Shape& shape, const Eigen::Vector3d& direction) {
  return std::visit([&](const auto& each) { return half_extent_of(each, direction); }, shape);
}

Eigen::Vector3d demagnetisation_factors(const Shape& shape) {
  return std::visit(
      [](const auto& each) {
        check_shape(each);
        return factors_of(each);
      },
      shape);
}

Eigen::Vector3d polarisation_of(const Magnet& magnet) {
  if (magnet.recoil_permeability == 1.0) return magnet.remanence;
  const Eigen::Vector3d factors = demagnetisation_factors(magnet.shape);
  return magnet.remanence.array() / (1.0 + (magnet.recoil_permeability - 1.0) * factors.array());
}

}  // namespace coilwright::magnetics
