#pragma once

#include <functional>
#include <vector>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/systems/gripper/gripper.hpp"
#include "coilwright/systems/gripper/object.hpp"

namespace coilwright::systems::gripper {

/// Mounting of the fingers and the object. The fingers close with the current of the operating point.
struct GripperTask {
  Mounting mounting{.angle = 0.5235987755982988, .spacing = 0.07};  ///< the paper's 30 deg; it gives no spacing
  Object object{.centre = {0.0, -0.016}};
  double open_current{};  ///< while the object is put between them, A; see GraspTask
  double acceleration{};  ///< upwards, that the hold must survive beside gravity, m/s^2; >= 0
  /// The largest current up to which the least one is searched, A; 0: the ampacity of the design's wire.
  double most_current{};
};

/// The quantities of a gripper with its task, for studies: objectives, limits, expressions and columns. `task` gives
/// the task of one design, whose settings may vary, but not the number of fingers; it must be pure. The grasp is
/// simulated only if one of these is requested, and once for all of them; `grip_least_current_A` takes a dozen grasps
/// more.
///
/// A design whose open fingers leave no room for the object has no values of a grasp, and the reason says by how much.
[[nodiscard]] std::vector<simulation::ResultQuantity> gripper_quantities(
    const std::function<GripperTask(const simulation::Settings&)>& task);

}  // namespace coilwright::systems::gripper
