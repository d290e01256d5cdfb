#pragma once

#include <array>
#include <cstddef>

#include "coilwright/systems/gripper/grasp.hpp"

namespace coilwright::systems::gripper {

/// How far the object and the fingers may be off, each way, in the order in which they are tried: m, and rad of the
/// mounting angle (a quarter of a degree to 15 degrees).
inline constexpr std::array<double, 9> tried_lengths = {0.1e-3, 0.25e-3, 0.5e-3, 0.75e-3, 1e-3,
                                                        1.5e-3, 2e-3,    3e-3,   5e-3};
inline constexpr std::size_t lengths_of_studies = 7;  // those up to 2 mm
inline constexpr std::array<double, 9> tried_angles = {0.004363323129985824, 0.008726646259971648, 0.017453292519943295,
                                                       0.03490658503988659,  0.05235987755982989,  0.08726646259971647,
                                                       0.1308996938995747,   0.17453292519943295,  0.2617993877991494};

/// The largest of the tried deviations of one number up to which every one of them leaves the object held; 0 where the
/// first of them loses it. The last one that is tried says that it may be more.
struct Tolerance {
  double below{};  ///< of the number being smaller; >= 0
  double above{};  ///< of its being larger; >= 0
};

/// How far a grasp may be from what was planned before the object is lost, one number off at a time.
struct PlacementTolerance {
  Tolerance height;          ///< of the object's centre, m; above: nearer to the palm
  Tolerance width;           ///< of the object, m; its mass stays
  Tolerance spacing;         ///< of the fingers' base joints, m; the object stays
  Tolerance mounting_angle;  ///< of all fingers, rad; above: further open

  /// The smallest of those of height, width and spacing, m.
  [[nodiscard]] double smallest_length() const;
};

/// Of an object that is held as planned; all 0 for one that is not. Each deviation is a grasp of its own, up to 72 of
/// them; where the open fingers leave no room, the object is lost. Rigid segments and object: a deviation that puts a
/// contact from one segment onto the next shows as the jump that it is. Throws as Gripper and grasp() do for the plan
/// itself.
[[nodiscard]] PlacementTolerance placement_tolerance(const actuator::Design& finger, const Mounting& mounting,
                                                     const Object& object, const GraspTask& task);

/// The smallest of those of height, width and spacing, m, tried up to 2 mm, of an object that is held as planned: for
/// searches; `gripper` is of that finger. Up to 42 grasps, the fewer the less is left. Throws as grasp().
[[nodiscard]] double length_tolerance(const actuator::Design& finger, const Gripper& gripper, const Object& object,
                                      const GraspTask& task);

}  // namespace coilwright::systems::gripper
