#include "coilwright/systems/gripper/placement_tolerance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coilwright::systems::gripper {
namespace {

constexpr Mounting mounting{.angle = std::numbers::pi / 6.0, .spacing = 0.07};
constexpr GraspTask task{.current = 1.4, .find_capacity = false};

Object cylinder(double mass) {
  return {.shape = ObjectShape::cylinder, .width = 0.06, .mass = mass, .friction = 0.8, .centre = {0.0, -0.016}};
}

bool holds_moved(const Object& object, double up) {
  Object moved = object;
  moved.centre.y() += up;
  return grasp(Gripper(actuator::Design{}, mounting), moved, task).holds;
}

// By grasps between the deviations that were tried, where nothing was looked at.
TEST(PlacementTolerance, HoldsWithinAndLosesTheObjectBeyond) {
  const Object object = cylinder(0.064);
  const PlacementTolerance found = placement_tolerance(actuator::Design{}, mounting, object, task);
  ASSERT_GT(found.height.below, 0.0);
  EXPECT_TRUE(holds_moved(object, -0.37 * found.height.below));
  EXPECT_TRUE(holds_moved(object, 0.37 * found.height.above));
  bool lost_lower = found.height.below == tried_lengths.back();
  bool lost_higher = found.height.above == tried_lengths.back();
  for (const double length : tried_lengths) {
    lost_lower = lost_lower || (length > found.height.below && !holds_moved(object, -length));
    lost_higher = lost_higher || (length > found.height.above && !holds_moved(object, length));
  }
  EXPECT_TRUE(lost_lower);
  EXPECT_TRUE(lost_higher);
}

// The palm is off as well: what is said of its spacing is what grasps between the fingers so spaced do.
TEST(PlacementTolerance, IsOfTheSpacingOfThePalmToo) {
  const Object object = cylinder(0.064);
  const auto holds_spaced = [&](double wider) {
    Mounting other = mounting;
    other.spacing += wider;
    return grasp(Gripper(actuator::Design{}, other), object, task).holds;
  };
  const Tolerance found = placement_tolerance(actuator::Design{}, mounting, object, task).spacing;
  EXPECT_TRUE(holds_spaced(-0.63 * found.below));
  EXPECT_TRUE(holds_spaced(0.63 * found.above));
  const auto beyond = [&](double held, double sign) {
    const auto next = std::ranges::upper_bound(tried_lengths, held);
    return next == tried_lengths.end() || !holds_spaced(sign * *next);
  };
  EXPECT_TRUE(beyond(found.below, -1.0));
  EXPECT_TRUE(beyond(found.above, 1.0));
}

// What needs all of the grip leaves less room to be off, and what is not held has none.
TEST(PlacementTolerance, ShrinksWithTheMass) {
  const PlacementTolerance light = placement_tolerance(actuator::Design{}, mounting, cylinder(0.02), task);
  const PlacementTolerance heavy = placement_tolerance(actuator::Design{}, mounting, cylinder(0.064), task);
  EXPECT_GE(light.smallest_length(), heavy.smallest_length());
  EXPECT_GE(light.mounting_angle.above, heavy.mounting_angle.above);
  const PlacementTolerance none = placement_tolerance(actuator::Design{}, mounting, cylinder(5.0), task);
  EXPECT_EQ(none.smallest_length(), 0.0);
  EXPECT_EQ(none.mounting_angle.below, 0.0);
}

}  // namespace
}  // namespace coilwright::systems::gripper
