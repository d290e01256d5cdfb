#include "coilwright/systems/gripper/gripper.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "coilwright/magnetics/wrench.hpp"
#include "systems/check.hpp"
#include "systems/gripper/placement.hpp"

namespace coilwright::systems::gripper {
namespace {

using actuator::ComponentKind;
using mechanics::JointVector;

actuator::Design mounted(actuator::Design design, const Mounting& mounting) {
  require(std::abs(mounting.angle) < 0.5 * std::numbers::pi, "mounting.angle", "between -90 and 90 deg",
          mounting.angle * 180.0 / std::numbers::pi, "deg");
  require(mounting.spacing > 0.0, "mounting.spacing", "finite and > 0", mounting.spacing, "m");
  require(mounting.fingers >= 2 && mounting.fingers <= most_fingers, "mounting.fingers",
          fmt::format("between 2 and {}", most_fingers), mounting.fingers);
  require(mounting.polarity == Polarity::same || mounting.fingers % 2 == 0, "mounting.fingers",
          "an even number where every second one is turned (polarity opposite)", mounting.fingers);
  // Outwards is against the side to which the joints open.
  design.surroundings.base_tilt = -mounting.angle;
  return design;
}

std::vector<FingerMagnet> magnets_of(const actuator::Design& design, const actuator::Dimensions& size) {
  std::vector<FingerMagnet> out;
  for (std::size_t i = 0; i < design.layout.size(); ++i) {
    if (design.layout[i].kind != ComponentKind::magnet) continue;
    const double half = size.magnet_half_pitch;
    out.push_back(
        {.centre = {.link = static_cast<int>(i) - 1, .along = i == 0 ? -half : half, .offset = size.axis_offset},
         .sense = static_cast<double>(design.layout[i].polarity)});
  }
  return out;
}

// What a force at a point of a finger and a torque on that link ask of its joints.
void add_load(const mechanics::PlanarChain& chain, const Placement& placement, const mechanics::LinkPoint& point,
              const Eigen::Vector2d& force, double torque, const JointVector& angles, JointVector& torques) {
  if (point.link < 0) return;
  torques += placement.jacobian(chain.jacobian(point, angles)).transpose() * force;
  for (int j = 0; j <= point.link; ++j) torques[j] += placement.sign * torque;
}

}  // namespace

Gripper::Gripper(const actuator::Design& finger, const Mounting& mounting)
    : assembly_(actuator::assemble_or_throw(mounted(finger, mounting))),
      mounting_(mounting),
      face_offset_(0.5 * finger.body.bottom_layer),
      base_length_(assembly_.segments.front().length),
      magnet_(finger.magnet.cylinder()),
      magnets_(magnets_of(finger, assembly_.dimensions)) {
  if (assembly_.model.internal_states() > 0)
    throw std::invalid_argument("gripper: the fingers must have no effects with states of their own");
  const double overlap = overlap_of_neighbours(JointVector::Zero(assembly_.model.joints()));
  if (overlap > 0.0)
    throw std::invalid_argument(
        fmt::format("mounting.spacing must leave {} straight fingers, {:.4g} mm wide, beside each other; got {:.4g} "
                    "mm, where neighbours overlap by {:.3g} mm",
                    mounting.fingers, assembly_.dimensions.width * 1e3, mounting.spacing * 1e3, overlap * 1e3));
}

double Gripper::overlap_of_neighbours(const JointVector& angles) const {
  if (mounting_.fingers == 2) return -std::numeric_limits<double>::infinity();
  const Placement here = placement(mounting_, 0);
  const mechanics::LinkFrames frames = finger().chain().frames(angles);
  double nearest = std::numeric_limits<double>::infinity();  // to the axis, of the face: it is straight in each segment
  for (int link = -1; link < assembly_.model.joints(); ++link)
    for (const double along : {face(link).begin, face(link).end})
      nearest = std::min(nearest, -here.point(frames[static_cast<std::size_t>(link) + 1].at(along, -face_offset_)).x());
  return assembly_.dimensions.width - 2.0 * nearest * std::tan(std::numbers::pi / mounting_.fingers);
}

JointVector Gripper::torques_among_alike(const JointVector& angles, double& largest_force) const {
  const mechanics::PlanarChain& chain = finger().chain();
  const Placement here = placement(mounting_, 0);
  const mechanics::LinkFrames frames = chain.frames(angles);
  const auto in_space = [](const Eigen::Vector2d& in_plane) {
    return Eigen::Vector3d(in_plane.x(), in_plane.y(), 0.0);
  };
  struct Placed {
    Eigen::Vector3d centre, axis;
  };
  const auto placed = [&](const FingerMagnet& magnet) {
    const mechanics::LinkFrame& frame = frames[static_cast<std::size_t>(magnet.centre.link) + 1];
    return Placed{.centre = in_space(here.point(frame.at(magnet.centre.along, magnet.centre.offset))),
                  .axis = magnet.sense * in_space(here.direction(frame.axis()))};
  };
  JointVector out = JointVector::Zero(angles.size());
  for (int k = 1; k < mounting_.fingers; ++k) {
    const Eigen::Matrix3d round_the_axis =
        Eigen::AngleAxisd(2.0 * std::numbers::pi * k / mounting_.fingers, Eigen::Vector3d::UnitY()).matrix();
    const double turned = mounting_.polarity == Polarity::opposite && k % 2 == 1 ? -1.0 : 1.0;
    for (const FingerMagnet& own : magnets_) {
      const Placed on = placed(own);
      for (const FingerMagnet& other : magnets_) {
        const Placed alike = placed(other);
        const Placed by{.centre = round_the_axis * alike.centre, .axis = turned * (round_the_axis * alike.axis)};
        const auto to_frame_of_other = Eigen::Quaterniond::FromTwoVectors(by.axis, Eigen::Vector3d::UnitZ());
        const magnetics::Wrench found = magnetics::wrench(
            magnet_, magnet_,
            {.position = to_frame_of_other * (on.centre - by.centre), .axis = to_frame_of_other * on.axis});
        const Eigen::Vector3d force = to_frame_of_other.conjugate() * found.force;
        const Eigen::Vector3d torque = to_frame_of_other.conjugate() * found.torque;
        // What points out of the plane cancels against the finger on its other side.
        add_load(chain, here, own.centre, force.head<2>(), torque.z(), angles, out);
        largest_force = std::max(largest_force, force.norm());
      }
    }
  }
  return out;
}

Gripper::Face Gripper::face(int link) const {
  if (link < 0) return {.begin = -base_length_, .end = 0.0};
  const mechanics::PlanarChain& chain = finger().chain();
  return {.begin = 0.0, .end = link + 1 == chain.joints() ? finger().tip().along : chain.link(link).length};
}

Gripper::Pull Gripper::magnet_torques(const JointVector& left, const JointVector& right) const {
  if (mounting_.fingers > 2) {
    Pull of_alike;
    of_alike.left = torques_among_alike(left, of_alike.largest_force);
    of_alike.right = torques_among_alike(right, of_alike.largest_force);
    return of_alike;
  }
  const mechanics::PlanarChain& chain = finger().chain();
  const Placement of_left = placement(mounting_, 0);
  const Placement of_right = placement(mounting_, 1);
  const mechanics::LinkFrames left_frames = chain.frames(left);
  const mechanics::LinkFrames right_frames = chain.frames(right);
  const double turned = mounting_.polarity == Polarity::same ? 1.0 : -1.0;
  Pull out{.left = JointVector::Zero(left.size()), .right = JointVector::Zero(right.size())};
  for (const FingerMagnet& a : magnets_) {
    const mechanics::LinkFrame& frame_a = left_frames[static_cast<std::size_t>(a.centre.link) + 1];
    const Eigen::Vector2d axis_a = a.sense * of_left.direction(frame_a.axis());
    const Eigen::Vector2d at_a = of_left.point(frame_a.at(a.centre.along, a.centre.offset));
    // The first magnet's own frame: z along its axis, x across it in the plane; y then points into the plane.
    const Eigen::Vector2d across(axis_a.y(), -axis_a.x());
    for (const FingerMagnet& b : magnets_) {
      const mechanics::LinkFrame& frame_b = right_frames[static_cast<std::size_t>(b.centre.link) + 1];
      const Eigen::Vector2d axis_b = turned * b.sense * of_right.direction(frame_b.axis());
      const Eigen::Vector2d between = of_right.point(frame_b.at(b.centre.along, b.centre.offset)) - at_a;
      const magnetics::Wrench on_b = magnetics::wrench(magnet_, magnet_,
                                                       {.position = {between.dot(across), 0.0, between.dot(axis_a)},
                                                        .axis = {axis_b.dot(across), 0.0, axis_b.dot(axis_a)}});
      const Eigen::Vector2d force = on_b.force.x() * across + on_b.force.z() * axis_a;
      const double torque_on_b = -on_b.torque.y();
      // Action and reaction: the two torques and the couple of the two forces cancel.
      const double torque_on_a = -torque_on_b - (between.x() * force.y() - between.y() * force.x());
      add_load(chain, of_right, b.centre, force, torque_on_b, right, out.right);
      add_load(chain, of_left, a.centre, -force, torque_on_a, left, out.left);
      out.largest_force = std::max(out.largest_force, force.norm());
    }
  }
  return out;
}

}  // namespace coilwright::systems::gripper
