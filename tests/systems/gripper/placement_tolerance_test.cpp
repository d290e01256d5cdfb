#include "coilwright/systems/gripper/placement_tolerance.hpp"

#include <gtest/gtest.h>

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
