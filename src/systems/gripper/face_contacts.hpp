#pragma once

#include <vector>

#include "coilwright/mechanics/contact_impulses.hpp"
#include "coilwright/systems/gripper/gripper.hpp"
#include "coilwright/systems/gripper/object.hpp"

namespace coilwright::systems::gripper {

/// Where the object is: its centre in the gripper's frame, m, and how far it has turned, rad.
struct ObjectPose {
  Eigen::Vector2d centre;
  double angle{};
};

/// A place where a finger and the object are nearest to each other, or overlap.
struct FacePoint {
  int finger{};
  mechanics::LinkPoint on_finger{};
  Eigen::Vector2d position;  ///< gripper's frame, m
  Eigen::Vector2d normal;    ///< unit, from the finger to the object
  double gap{};              ///< m, below zero where they overlap
};

/// The candidates between one finger, in the frames of its chain, and the object: of a round one the nearest point of
/// every face, of a box its corners and the fingertip. Places that lie behind a face by more than half the object do
/// not count.
[[nodiscard]] std::vector<FacePoint> face_points(const Gripper& gripper, int finger,
                                                 const mechanics::LinkFrames& frames, const Object& object,
                                                 const ObjectPose& pose);

}  // namespace coilwright::systems::gripper
