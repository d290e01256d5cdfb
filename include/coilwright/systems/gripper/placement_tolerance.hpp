#pragma once

#include <array>
#include <cstddef>

#include "coilwright/systems/gripper/grasp.hpp"

namespace coilwright::systems::gripper {

/// Deviations that are tried, each way, in this order: m for the object and the spacing, and rad for the mounting angle
/// (a quarter of a degree to 15 degrees).
inline constexpr std::array<double, 9> tried_lengths = {0.1e-3, 0.25e-3, 0.5e-3, 0.75e-3, 1e-3,
                                                        1.5e-3, 2e-3,    3e-3,   5e-3};
inline constexpr std::size_t lengths_of_studies = 7;  // those up to 2 mm
inline constexpr std::array<double, 9> tried_angles = {0.004363323129985824, 0.008726646259971648, 0.017453292519943295,
                                                       0.03490658503988659,  0.05235987755982989,  0.08726646259971647,
                                                       0.1308996938995747,   0.17453292519943295,  0.2617993877991494};

/// The largest of the tried deviations of one number up to which each leaves the object held; 0 if the first one loses
/// it. If it is the last one tried, the tolerance may be larger.
struct Tolerance {
  double below{};  ///< for a smaller value of the number; >= 0
  double above{};  ///< for a larger value of the number; >= 0
};

/// Tolerances of a grasp against deviations from the plan, one number at a time.
struct PlacementTolerance {
  Tolerance height;          ///< of the object's centre, m; `above` is nearer to the palm
  Tolerance width;           ///< of the object, m; its mass stays
  Tolerance spacing;         ///< of the fingers' base joints, m; the object stays
  Tolerance mounting_angle;  ///< of all fingers, rad; `above` is further open

  /// The smallest of those of height, width and spacing, m.
  [[nodiscard]] double smallest_length() const;
};

/// Computes the tolerances for an object that is held as planned; all are 0 for one that is not. Each deviation is a
/// grasp of its own, up to 72 of them; the object counts as lost if the open fingers leave no room. Segments and object
/// are rigid, so a deviation that moves a contact onto the next segment shows as a jump. Throws as Gripper and grasp()
/// do for the plan itself.
[[nodiscard]] PlacementTolerance placement_tolerance(const actuator::Design& finger, const Mounting& mounting,
                                                     const Object& object, const GraspTask& task);

/// The smallest tolerance of height, width and spacing, m, up to 2 mm, for an object that is held as planned; for
/// searches. `gripper` is of that finger. It takes up to 42 grasps, fewer for a small tolerance. Throws as grasp().
[[nodiscard]] double length_tolerance(const actuator::Design& finger, const Gripper& gripper, const Object& object,
                                      const GraspTask& task);

}  // namespace coilwright::systems::gripper
