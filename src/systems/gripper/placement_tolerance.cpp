#include "coilwright/systems/gripper/placement_tolerance.hpp"

#include <algorithm>
#include <functional>
#include <optional>
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

// What is planned. Each deviation of it is a grasp of its own.
struct Plan {
  const actuator::Design& finger;
  const Gripper& gripper;  // of the fingers as they are planned
  std::optional<Mounting> mounting;
  Object object;
  GraspTask task;

  [[nodiscard]] bool holds() const {
    return (mounting ? grasp(Gripper(finger, *mounting), object, task) : grasp(gripper, object, task)).holds;
  }
};

Plan plan_of(const actuator::Design& finger, const Gripper& gripper, const Object& object, GraspTask task) {
  task.find_capacity = false;
  return {.finger = finger, .gripper = gripper, .mounting = {}, .object = object, .task = task};
}

// Of one number, which `move` changes by a deviation.
Tolerance tolerance(const Plan& plan, std::span<const double> deviations, void (*move)(Plan&, double)) {
  const auto is_held = [&](double deviation) {
    Plan moved = plan;
    move(moved, deviation);
    return moved.holds();
  };
  return {.below = largest_held(deviations, -1.0, is_held), .above = largest_held(deviations, 1.0, is_held)};
}

void move_height(Plan& plan, double by) {
  plan.object.centre.y() += by;
}
void move_width(Plan& plan, double by) {
  plan.object.width += by;
}
void move_spacing(Plan& plan, double by) {
  plan.mounting = plan.gripper.mounting();
  plan.mounting->spacing += by;
}
void turn_mounting(Plan& plan, double by) {
  plan.mounting = plan.gripper.mounting();
  plan.mounting->angle += by;
}

}  // namespace

double PlacementTolerance::smallest_length() const {
  return std::min({height.below, height.above, width.below, width.above, spacing.below, spacing.above});
}

PlacementTolerance placement_tolerance(const actuator::Design& finger, const Mounting& mounting, const Object& object,
                                       const GraspTask& task) {
  const Gripper gripper(finger, mounting);
  const Plan plan = plan_of(finger, gripper, object, task);
  if (!plan.holds()) return {};
  return {.height = tolerance(plan, tried_lengths, move_height),
          .width = tolerance(plan, tried_lengths, move_width),
          .spacing = tolerance(plan, tried_lengths, move_spacing),
          .mounting_angle = tolerance(plan, tried_angles, turn_mounting)};
}

double length_tolerance(const actuator::Design& finger, const Gripper& gripper, const Object& object,
                        const GraspTask& task) {
  const Plan plan = plan_of(finger, gripper, object, task);
  std::span<const double> lengths{tried_lengths.data(), lengths_of_studies};
  // What is lost earlier on one side need not be tried further on the others.
  double least = lengths.back();
  for (const auto move : {move_height, move_width, move_spacing}) {
    const Tolerance found = tolerance(plan, lengths, move);
    least = std::min({least, found.below, found.above});
    while (!lengths.empty() && lengths.back() > least) lengths = lengths.first(lengths.size() - 1);
  }
  return least;
}

}  // namespace coilwright::systems::gripper
