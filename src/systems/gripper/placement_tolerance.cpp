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

// Each tries a grasp of its own.
class Deviations {
 public:
  Deviations(const Gripper& gripper, const Object& object, const GraspTask& task)
      : gripper_{gripper}, object_{object}, task_{task} {
    task_.find_capacity = false;
  }

  [[nodiscard]] bool planned() const { return grasp(gripper_, object_, task_).holds; }

  [[nodiscard]] Tolerance height(std::span<const double> lengths) const {
    return tolerance(lengths, [this](double deviation) {
      Object moved = object_;
      moved.centre.y() += deviation;
      return grasp(gripper_, moved, task_).holds;
    });
  }
  [[nodiscard]] Tolerance width(std::span<const double> lengths) const {
    return tolerance(lengths, [this](double deviation) {
      Object other = object_;
      other.width += deviation;
      return grasp(gripper_, other, task_).holds;
    });
  }
  [[nodiscard]] Tolerance mounting(const actuator::Design& finger, const Mounting& mounting) const {
    return tolerance(tried_angles, [&](double deviation) {
      Mounting turned = mounting;
      turned.angle += deviation;
      return grasp(Gripper(finger, turned), object_, task_).holds;
    });
  }

 private:
  const Gripper& gripper_;
  Object object_;
  GraspTask task_;
};

}  // namespace

double PlacementTolerance::smallest_length() const {
  return std::min({height.below, height.above, width.below, width.above});
}

PlacementTolerance placement_tolerance(const actuator::Design& finger, const Mounting& mounting, const Object& object,
                                       const GraspTask& task) {
  const Gripper gripper(finger, mounting);
  const Deviations from(gripper, object, task);
  if (!from.planned()) return {};
  return {.height = from.height(tried_lengths),
          .width = from.width(tried_lengths),
          .mounting_angle = from.mounting(finger, mounting)};
}

double length_tolerance(const Gripper& gripper, const Object& object, const GraspTask& task) {
  const Deviations from(gripper, object, task);
  std::span<const double> lengths{tried_lengths.data(), lengths_of_studies};
  // What is lost earlier on one side need not be tried further on the others.
  double least = lengths.back();
  const auto narrow = [&](const Tolerance& found) {
    least = std::min({least, found.below, found.above});
    while (!lengths.empty() && lengths.back() > least) lengths = lengths.first(lengths.size() - 1);
  };
  narrow(from.height(lengths));
  narrow(from.width(lengths));
  return least;
}

}  // namespace coilwright::systems::gripper
