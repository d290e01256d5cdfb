#include "coilwright/systems/gripper/gripper.hpp"

#include <algorithm>
#include <cmath>
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
}

Gripper::Face Gripper::face(int link) const {
  if (link < 0) return {.begin = -base_length_, .end = 0.0};
  const mechanics::PlanarChain& chain = finger().chain();
  return {.begin = 0.0, .end = link + 1 == chain.joints() ? finger().tip().along : chain.link(link).length};
}

Gripper::Pull Gripper::magnet_torques(const JointVector& left, const JointVector& right) const {
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
