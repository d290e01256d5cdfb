#include "coilwright/systems/gripper/placement_tolerance.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>

namespace coilwright::systems::gripper {
namespace {

// The largest of `deviations`, times `sign`, up to which each of them is held. Where something leaves no room, it is
// not.
double largest_held(std::span<const double> deviations, double sign, const std::function<bool(double)>& is_held) {
  double largest = 0.0;
  for (const double deviation : deviations) {
    try {
      if (!is_held(sign * deviation)) break;
    } catch (const std::invalid_argument&) {
      break;
    }
    largest = deviation;
  }
  return largest;
}

Tolerance tolerance(std::span<const double> deviations, const std::function<bool(double)>& is_held) {
  return {.below = largest_held(deviations, -1.0, is_held), .above = largest_held(deviations, 1.0, is_held)};
}

}  // namespace

double PlacementTolerance::smallest_length() const {
  return std::min({height.below, height.above, width.below, width.above});
}

PlacementTolerance placement_tolerance(const actuator::Design& finger, const Mounting& mounting, const Object& object,
                                       GraspTask task) {
  task.find_capacity = false;
  const Gripper gripper(finger, mounting);
  if (!grasp(gripper, object, task).holds) return {};
  return {.height = tolerance(tried_lengths,
                              [&](double deviation) {
                                Object moved = object;
                                moved.centre.y() += deviation;
                                return grasp(gripper, moved, task).holds;
                              }),
          .width = tolerance(tried_lengths,
                             [&](double deviation) {
                               Object other = object;
                               other.width += deviation;
                               return grasp(gripper, other, task).holds;
                             }),
          .mounting_angle = tolerance(tried_angles, [&](double deviation) {
            Mounting turned = mounting;
            turned.angle += deviation;
            return grasp(Gripper(finger, turned), object, task).holds;
          })};
}

}  // namespace coilwright::systems::gripper
