#include "systems/gripper/scene.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "coilwright/simulation/equilibrium.hpp"

namespace coilwright::systems::gripper {
namespace {

// Opened by negative current, fingers land and lie on the faces of their slits, which are so stiff that explicit steps
// of 0.2 ms rattled on them, and implicit ones of 1 ms: they never came to rest, and wandered by more than a degree.
TEST(Scene, LeavesOpenedFingersAtRestOnTheirFaces) {
  const Gripper gripper(actuator::Design{}, {.angle = std::numbers::pi / 6.0, .spacing = 0.3});
  const Object ball{
      .shape = ObjectShape::sphere, .width = 0.06, .mass = 0.05, .friction = 0.8, .centre = {0.0, -0.016}};
  for (const double before : {0.0, -1.4})
    for (const double current : {-0.5, -1.0, -1.4}) {
      Scene scene(gripper, ball, before);
      for (double time = 0.0; time < 1.0;) time += scene.advance({.current = current, .apart = true}, 2e-3);
      EXPECT_LT(scene.finger_energy(), 1e-20);
      // 0.3 m apart their magnets do not feel each other: each rests where it would by itself.
      const actuator::Model& finger = gripper.finger();
      const auto alone = simulation::find_equilibrium(finger, finger.all_coils(current), scene.angles(0));
      ASSERT_TRUE(alone);
      EXPECT_LT(alone->maxCoeff(), 0.0);  // pressed
      for (int f = 0; f < 2; ++f) EXPECT_LT((scene.angles(f) - *alone).cwiseAbs().maxCoeff(), 1e-6);
    }
}

}  // namespace
}  // namespace coilwright::systems::gripper
