#include "coilwright/magnetics/field.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "magnetics/magnet_field.hpp"
#include "magnetics/require.hpp"

namespace coilwright::magnetics {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using FieldSamples = std::vector<FieldSample>;

void add_own(const DrivenCoil& coil, Wanted wanted, const Points& points, FieldSamples& samples) {
  add_round_field(coil, wanted, points, samples);
}

void add_own(const Magnet& magnet, Wanted wanted, const Points& points, FieldSamples& samples) {
  const Eigen::Vector3d polarisation = polarisation_of(magnet);
  if (const auto* ring = std::get_if<Ring>(&magnet.shape))
    add_round_field(*ring, polarisation, wanted, points, samples);
  else
    add_cuboid_field(std::get<Cuboid>(magnet.shape), polarisation, wanted, points, samples);
}

FieldSamples samples_of(std::span<const Body> bodies, std::span<const Eigen::Vector3d> points, Wanted wanted) {
  for (const Eigen::Vector3d& point : points) require(point.allFinite(), "point", "finite", point.norm());
  FieldSamples total(points.size());
  for (const Body& body : bodies) {
    check(body);
    const Eigen::Matrix3d axes = rotation_of(body.pose);
    Points local(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) local[i] = axes.transpose() * (points[i] - body.pose.position);
    FieldSamples own(points.size());
    std::visit([&](const auto& part) { add_own(part, wanted, local, own); }, body.part);
    for (std::size_t i = 0; i < points.size(); ++i) {
      total[i].flux_density += axes * own[i].flux_density;
      total[i].gradient += axes * own[i].gradient * axes.transpose();
    }
  }
  return total;
}

bool is_within(const Ring& ring, const Eigen::Vector3d& point) {
  const double radius = std::hypot(point.x(), point.y());
  return std::abs(point.z()) < 0.5 * ring.length && radius < ring.outer_radius &&
         (ring.inner_radius == 0.0 || radius > ring.inner_radius);
}

bool is_within(const Cuboid& cuboid, const Eigen::Vector3d& point) {
  return (2.0 * point.cwiseAbs().array() < cuboid.size.array()).all();
}

constexpr double on_it = 1e-12;  // of the size

// Of a face's edge, charged by what of the magnetisation goes through a face that ends there.
bool is_charged_edge(const Ring& ring, const Eigen::Vector3d& remanence, const Eigen::Vector3d& point) {
  const double size = ring.outer_radius + ring.length;
  const double radius = std::hypot(point.x(), point.y());
  const bool on_side = std::abs(radius - ring.outer_radius) <= on_it * size ||
                       (ring.inner_radius > 0.0 && std::abs(radius - ring.inner_radius) <= on_it * size);
  if (!on_side || std::abs(std::abs(point.z()) - 0.5 * ring.length) > on_it * size) return false;
  const double through_side = (remanence.x() * point.x() + remanence.y() * point.y()) / radius;
  return std::hypot(remanence.z(), through_side) > on_it * remanence.norm();
}

bool is_charged_edge(const Cuboid& cuboid, const Eigen::Vector3d& remanence, const Eigen::Vector3d& point) {
  const double least = on_it * cuboid.size.norm();
  const Eigen::Array3d beyond = point.array().abs() - 0.5 * cuboid.size.array();
  if ((beyond > least).any()) return false;
  const Eigen::Array3d on_face = (beyond >= -least).cast<double>();
  return on_face.sum() >= 2.0 && (on_face * remanence.array()).matrix().norm() > on_it * remanence.norm();
}

Eigen::Vector3d in_own_axes(const Body& body, const Eigen::Vector3d& point) {
  return rotation_of(body.pose).transpose() * (point - body.pose.position);
}

}  // namespace

std::vector<FieldSample> field(std::span<const Body> bodies, std::span<const Eigen::Vector3d> points) {
  return samples_of(bodies, points, Wanted::gradient);
}

std::vector<Eigen::Vector3d> flux_density(std::span<const Body> bodies, std::span<const Eigen::Vector3d> points) {
  Points out;
  out.reserve(points.size());
  for (const FieldSample& sample : samples_of(bodies, points, Wanted::flux_density)) out.push_back(sample.flux_density);
  return out;
}

bool is_inside(const Body& body, const Eigen::Vector3d& point) {
  return std::visit([local = in_own_axes(body, point)](const auto& shape) { return is_within(shape, local); },
                    shape_of(body));
}

bool is_on_edge(const Body& body, const Eigen::Vector3d& point) {
  const auto* magnet = std::get_if<Magnet>(&body.part);
  if (magnet == nullptr) return false;
  return std::visit(
      [&](const auto& shape) { return is_charged_edge(shape, magnet->remanence, in_own_axes(body, point)); },
      magnet->shape);
}

}  // namespace coilwright::magnetics
