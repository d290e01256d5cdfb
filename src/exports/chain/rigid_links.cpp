#include "exports/chain/rigid_links.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coilwright::exports {
namespace {

// Share of mass times distance squared that stands in for the inertia of a point; it moves no frequency by more.
constexpr double inertia_of_a_point = 1e-7;
// A box to look at has at least this share of its link's length, and of 10 mm, on every side.
constexpr double thinnest = 0.1;
constexpr double usual_length = 10e-3;

RigidLink body_of(const mechanics::Link& link, double joint_along) {
  const double reach = std::hypot(link.com_along, link.com_offset);
  const double length = std::max(link.length, thinnest * usual_length);
  // The joint is at the face of the segment, and its centre of mass near the middle of its height.
  const double height = std::max(2.0 * std::abs(link.com_offset), thinnest * length);
  return {.joint = in_frame(joint_along, 0.0),
          .centre = in_frame(link.com_along, link.com_offset),
          .mass = link.mass,
          .inertia = std::max(link.inertia, inertia_of_a_point * link.mass * std::max(reach * reach, 1e-6)),
          .box_centre = in_frame(0.5 * length, link.com_offset),
          .box_size = {height, height, length}};
}

}  // namespace

Eigen::Vector3d in_frame(double along, double offset) {
  return {-offset + 0.0, 0.0, -along + 0.0};  // no negative zeros
}

std::vector<RigidLink> rigid_links(const mechanics::PlanarChain& chain) {
  std::vector<RigidLink> bodies;
  double joint_along = 0.0;
  for (const mechanics::Link& link : chain.links()) {
    bodies.push_back(body_of(link, joint_along));
    joint_along = link.length;
  }
  return bodies;
}

std::string words(const std::vector<double>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

std::string coordinates(const Eigen::Vector3d& vector) {
  return fmt::format("{} {} {}", vector.x(), vector.y(), vector.z());
}

std::string planar_inertia_remark() {
  return "inertia about the axes in the plane of bending: the planar model does not know it, and each body has that of "
         "its bending for all axes";
}

std::string joint_name(int joint) {
  return fmt::format("joint{}", joint + 1);
}

}  // namespace coilwright::exports
