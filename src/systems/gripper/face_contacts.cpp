#include "systems/gripper/face_contacts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "systems/gripper/placement.hpp"

namespace coilwright::systems::gripper {
namespace {

using Eigen::Vector2d;
using mechanics::LinkFrame;

// Out of the gripping face, in the chain's frame: against the offset.
Vector2d outwards(const LinkFrame& frame) {
  return {frame.cosine, frame.sine};
}

using Places = std::array<double, mechanics::max_joints + 1>;

// Where a point is along the axis of every link, base first, and so before, over or beyond its face.
Places places_along(const Gripper& gripper, const mechanics::LinkFrames& frames, const Vector2d& point) {
  Places out{};
  for (int link = -1; link < gripper.finger().joints(); ++link) {
    const LinkFrame& frame = frames[static_cast<std::size_t>(link) + 1];
    out[static_cast<std::size_t>(link) + 1] = (point - frame.joint).dot(frame.axis());
  }
  return out;
}

// Whether a point is before the face of a link, or beyond it, and over that of the neighbour there, which is nearer.
// Over neither it is where the joint between them is bent away from it: an edge, of both.
bool neighbour_is_nearer(const Gripper& gripper, const Places& along, int link) {
  const auto at = [&](int each) { return along[static_cast<std::size_t>(each) + 1]; };
  if (link >= 0 && at(link) < gripper.face(link).begin) return at(link - 1) <= gripper.face(link - 1).end;
  if (link + 1 < gripper.finger().joints() && at(link) > gripper.face(link).end)
    return at(link + 1) >= gripper.face(link + 1).begin;
  return false;
}

// The nearest point of every face to a round object.
void add_round(const Gripper& gripper, int finger, const Placement& placement, const mechanics::LinkFrames& frames,
               double radius, const Vector2d& centre, std::vector<FacePoint>& out) {
  const Vector2d local = placement.in_chain(centre);
  const Places along = places_along(gripper, frames, local);
  for (int link = -1; link < gripper.finger().joints(); ++link) {
    if (neighbour_is_nearer(gripper, along, link)) continue;
    const LinkFrame& frame = frames[static_cast<std::size_t>(link) + 1];
    const Gripper::Face face = gripper.face(link);
    const double here = along[static_cast<std::size_t>(link) + 1];
    const double nearest = std::clamp(here, face.begin, face.end);
    const Vector2d on_face = frame.joint + nearest * frame.axis() + gripper.face_offset() * outwards(frame);
    const Vector2d towards = local - on_face;
    const bool beside = nearest != here;
    const double above = towards.dot(outwards(frame));
    if (above <= 0.0) continue;  // its centre lies behind the face
    const double distance = beside ? towards.norm() : above;
    out.push_back({.finger = finger,
                   .on_finger = {.link = link, .along = nearest, .offset = -gripper.face_offset()},
                   .position = placement.point(on_face),
                   .normal = placement.direction(beside ? Vector2d(towards / distance) : outwards(frame)),
                   .gap = distance - radius});
  }
}

std::array<Vector2d, 4> corners(const Object& object, const ObjectPose& pose) {
  const Eigen::Rotation2Dd turned(pose.angle);
  const double x = 0.5 * object.width;
  const double y = 0.5 * object.height;
  return {pose.centre + turned * Vector2d(-x, -y), pose.centre + turned * Vector2d(x, -y),
          pose.centre + turned * Vector2d(x, y), pose.centre + turned * Vector2d(-x, y)};
}

void add_corners(const Gripper& gripper, int finger, const Placement& placement, const mechanics::LinkFrames& frames,
                 const Object& object, const ObjectPose& pose, std::vector<FacePoint>& out) {
  for (const Vector2d& corner : corners(object, pose)) {
    const Vector2d local = placement.in_chain(corner);
    for (int link = -1; link < gripper.finger().joints(); ++link) {
      const LinkFrame& frame = frames[static_cast<std::size_t>(link) + 1];
      const Gripper::Face face = gripper.face(link);
      const double along = (local - frame.joint).dot(frame.axis());
      const double gap = (local - frame.joint).dot(outwards(frame)) - gripper.face_offset();
      if (along < face.begin || along > face.end || gap < -0.5 * std::min(object.width, object.height)) continue;
      out.push_back({.finger = finger,
                     .on_finger = {.link = link, .along = along, .offset = -gripper.face_offset()},
                     .position = corner,
                     .normal = placement.direction(outwards(frame)),
                     .gap = gap});
    }
  }
}

// The fingertip on the side of a box that it is nearest to.
void add_tip(const Gripper& gripper, int finger, const Placement& placement, const mechanics::LinkFrames& frames,
             const Object& object, const ObjectPose& pose, std::vector<FacePoint>& out) {
  const int last = gripper.finger().joints() - 1;
  const mechanics::LinkPoint tip{.link = last, .along = gripper.face(last).end, .offset = -gripper.face_offset()};
  const Vector2d position = placement.point(frames[static_cast<std::size_t>(last) + 1].at(tip.along, tip.offset));
  const Eigen::Rotation2Dd turned(pose.angle);
  const Vector2d local = turned.inverse() * (position - pose.centre);
  const Vector2d outside = local.cwiseAbs() - 0.5 * Vector2d(object.width, object.height);
  const int side = outside.x() > outside.y() ? 0 : 1;
  if (outside[1 - side] > 0.0) return;  // nearer to a corner, which has its own candidates
  Vector2d normal = Vector2d::Zero();
  normal[side] = local[side] > 0.0 ? -1.0 : 1.0;
  out.push_back(
      {.finger = finger, .on_finger = tip, .position = position, .normal = turned * normal, .gap = outside[side]});
}

}  // namespace

std::vector<FacePoint> face_points(const Gripper& gripper, int finger, const mechanics::LinkFrames& frames,
                                   const Object& object, const ObjectPose& pose) {
  const Placement here = placement(gripper.mounting(), finger);
  std::vector<FacePoint> out;
  if (object.has_flat_sides()) {
    add_corners(gripper, finger, here, frames, object, pose, out);
    add_tip(gripper, finger, here, frames, object, pose, out);
  } else {
    add_round(gripper, finger, here, frames, 0.5 * object.width, pose.centre, out);
  }
  return out;
}

}  // namespace coilwright::systems::gripper
