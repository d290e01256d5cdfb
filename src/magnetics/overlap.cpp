#include "coilwright/magnetics/overlap.hpp"

#include <Eigen/Geometry>
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

double size_of(const Outline& ring) {
  return std::min(ring.length, ring.outer_radius - ring.inner_radius);
}

// Whether a point, seen from a ring's own frame, lies deeper than that inside it.
bool is_inside(const Outline& ring, const Eigen::Vector3d& point, double depth) {
  const double radius = std::hypot(point.x(), point.y());
  const double inner = ring.inner_radius == 0.0 ? -1.0 : ring.inner_radius + depth;
  return std::abs(point.z()) < 0.5 * ring.length - depth && radius < ring.outer_radius - depth && radius > inner;
}

// Whether a point on or in `own`, taken to the other's frame by `place`, lies inside `other`.
template <class Place>
bool any_point_inside(const Outline& own, const Outline& other, double depth, const Place& place) {
  for (int a = 0; a < around; ++a) {
    const double angle = 2.0 * std::numbers::pi * a / around;
    const auto inside = [&](double radius, double height) {
      return is_inside(other, place({radius * std::cos(angle), radius * std::sin(angle), height}), depth);
    };
    for (int i = 0; i <= along; ++i) {
      const double share = static_cast<double>(i) / along;
      const double height = (share - 0.5) * own.length;
      // Within as well: bodies that are alike and in one place have no point of their surfaces inside each other.
      const double middle = 0.5 * (own.inner_radius + own.outer_radius);
      if (inside(own.outer_radius, height) || inside(middle, height)) return true;
      if (own.inner_radius > 0.0 && inside(own.inner_radius, height)) return true;
      const double radius = own.inner_radius + share * (own.outer_radius - own.inner_radius);
      for (const double face : std::array{-0.5 * own.length, 0.5 * own.length})
        if (inside(radius, face)) return true;
    }
  }
  return false;
}

// Whether a plane across the first axis, or a cylinder round it, lies between them: nearly always, and told at once.
bool plainly_apart(const Outline& first, const Outline& second, const Pose& pose) {
  const double along_axis = std::abs(pose.axis.normalized().z());
  const double across_axis = std::sqrt(std::max(0.0, 1.0 - along_axis * along_axis));
  const double height = 0.5 * second.length * along_axis + second.outer_radius * across_axis;
  const double reach = 0.5 * second.length * across_axis + second.outer_radius;
  return std::abs(pose.position.z()) >= 0.5 * first.length + height ||
         std::hypot(pose.position.x(), pose.position.y()) >= first.outer_radius + reach;
}

}  // namespace

Outline outline_of(const ThickCoil& coil) {
  return {.inner_radius = coil.inner_radius(), .outer_radius = coil.outer_radius(), .length = coil.length()};
}

Outline outline_of(const CylinderMagnet& magnet) {
  return {.inner_radius = 0.0, .outer_radius = magnet.radius(), .length = magnet.length()};
}

bool overlap(const Outline& first, const Outline& second, const Pose& pose) {
  if (plainly_apart(first, second, pose)) return false;
  const double depth = least_depth * std::min(size_of(first), size_of(second));
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), pose.axis);
  return any_point_inside(
             second, first, depth,
             [&](const Eigen::Vector3d& point) { return Eigen::Vector3d(pose.position + turn * point); }) ||
         any_point_inside(first, second, depth, [&](const Eigen::Vector3d& point) {
           return Eigen::Vector3d(turn.conjugate() * (point - pose.position));
         });
}

}  // namespace coilwright::magnetics
