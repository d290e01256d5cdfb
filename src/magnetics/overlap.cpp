#include "coilwright/magnetics/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coilwright::magnetics {
namespace {

constexpr int around = 144;
constexpr int along = 48;
// Of the smaller body's size: parts that touch do not overlap.
constexpr double least_depth = 1e-3;

double size_of(const Ring& ring) {
  return std::min(ring.length, ring.outer_radius - ring.inner_radius);
}

double size_of(const Cuboid& cuboid) {
  return cuboid.size.minCoeff();
}

// Whether a point, seen from a body's own axes, lies deeper than that inside it.
bool is_inside(const Ring& ring, const Eigen::Vector3d& point, double depth) {
  const double radius = std::hypot(point.x(), point.y());
  const double inner = ring.inner_radius == 0.0 ? -1.0 : ring.inner_radius + depth;
  return std::abs(point.z()) < 0.5 * ring.length - depth && radius < ring.outer_radius - depth && radius > inner;
}

bool is_inside(const Cuboid& cuboid, const Eigen::Vector3d& point, double depth) {
  return (point.cwiseAbs().array() < 0.5 * cuboid.size.array() - depth).all();
}

// Whether `found` is true of a point on or in a body. Within as well: bodies that are alike and in one place have no
// point of their surfaces inside each other.
template <class Found>
bool any_point(const Ring& ring, const Found& found) {
  for (int a = 0; a < around; ++a) {
    const double angle = 2.0 * std::numbers::pi * a / around;
    const auto at = [&](double radius, double height) {
      return found(Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), height));
    };
    for (int i = 0; i <= along; ++i) {
      const double share = static_cast<double>(i) / along;
      const double height = (share - 0.5) * ring.length;
      const double middle = 0.5 * (ring.inner_radius + ring.outer_radius);
      if (at(ring.outer_radius, height) || at(middle, height)) return true;
      if (ring.inner_radius > 0.0 && at(ring.inner_radius, height)) return true;
      const double radius = ring.inner_radius + share * (ring.outer_radius - ring.inner_radius);
      for (const double face : std::array{-0.5 * ring.length, 0.5 * ring.length})
        if (at(radius, face)) return true;
    }
  }
  return false;
}

template <class Found>
bool any_point(const Cuboid& cuboid, const Found& found) {
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i <= along; ++i)
      for (int j = 0; j <= along; ++j)
        for (const double level : {-0.5, 0.0, 0.5}) {
          Eigen::Vector3d share;
          share[axis] = level;
          share[(axis + 1) % 3] = static_cast<double>(i) / along - 0.5;
          share[(axis + 2) % 3] = static_cast<double>(j) / along - 0.5;
          if (found(Eigen::Vector3d(share.cwiseProduct(cuboid.size)))) return true;
        }
  return false;
}

// Whether a plane across the first axis, or a cylinder round it, lies between them: nearly always, and told at once.
bool plainly_apart(const Shape& first, const Shape& second, const Pose& pose, const Eigen::Matrix3d& axes) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d aside(pose.position.x(), pose.position.y(), 0.0);
  const auto between = [&](const Eigen::Vector3d& direction) {
    return std::abs(direction.dot(pose.position)) >=
           half_extent(first, direction) + half_extent(second, axes.transpose() * direction);
  };
  return between(up) || (aside.norm() > 0.0 && between(aside.normalized()));
}

}  // namespace

bool overlap(const Shape& first, const Shape& second, const Pose& pose) {
  const Eigen::Matrix3d axes = rotation_of(pose);
  if (plainly_apart(first, second, pose, axes)) return false;
  return std::visit(
      [&](const auto& one, const auto& other) {
        const double depth = least_depth * std::min(size_of(one), size_of(other));
        return any_point(other,
                         [&](const Eigen::Vector3d& point) {
                           return is_inside(one, Eigen::Vector3d(pose.position + axes * point), depth);
                         }) ||
               any_point(one, [&](const Eigen::Vector3d& point) {
                 return is_inside(other, Eigen::Vector3d(axes.transpose() * (point - pose.position)), depth);
               });
      },
      first, second);
}

bool overlap(const Body& first, const Body& second) {
  return overlap(shape_of(first), shape_of(second), seen_from(first.pose, second.pose));
}

}  // namespace coilwright::magnetics
