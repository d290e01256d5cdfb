#include "coilwright/mechanics/face_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace coilwright::mechanics {
namespace {

constexpr FaceContact contact{.closing_angle = -0.031, .stiffness = 80.0, .damping = 0.02};

TEST(FaceContact, PushesOnlyWhereFacesOverlap) {
  EXPECT_EQ(contact.torque(-0.030, -9.0), 0.0);
  EXPECT_NEAR(contact.torque(-0.035, 0.0), 80.0 * 0.004, 1e-15);
}

TEST(FaceContact, ResistsClosingAndNeverPulls) {
  EXPECT_NEAR(contact.torque(-0.035, -2.0), 80.0 * 0.004 + 0.04, 1e-15);
  EXPECT_EQ(contact.torque(-0.035, 1e3), 0.0);
}

TEST(FaceContact, TorqueIsTheSlopeOfItsEnergy) {
  const double step = 1e-6;
  const double slope = (contact.energy(-0.04 + step) - contact.energy(-0.04 - step)) / (2 * step);
  EXPECT_NEAR(contact.torque(-0.04, 0.0), -slope, 1e-9 * 80.0);
  EXPECT_EQ(contact.tangent_stiffness(-0.04), 80.0);
  EXPECT_EQ(contact.tangent_stiffness(0.2), 0.0);
}

// I theta'' + b theta' + k theta = 0 with I = 1/mobility: b over its critical value 2 sqrt(k I) is the ratio.
TEST(FaceContact, DampsByAShareOfWhatIsCritical) {
  const double stiffness = 37.0, inertia = 3.1e-6;
  EXPECT_DOUBLE_EQ(contact_damping(stiffness, 1.0 / inertia), 0.3 * 2.0 * std::sqrt(stiffness * inertia));
}

// The strip picture integrated numerically: sum over strips of E w dy (y theta / t) y.
TEST(FaceContact, WallStiffnessIsTheSumOfItsStrips) {
  const FaceWalls walls{.width = 21e-3, .height = 19e-3, .thickness = 0.8e-3, .young_modulus = 0.9e6};
  double sum = 0.0;
  const int strips = 2000;
  for (int i = 0; i < strips; ++i) {
    const double y = (i + 0.5) * walls.height / strips;
    sum += walls.young_modulus * walls.width * (walls.height / strips) * y * y / walls.thickness;
  }
  EXPECT_NEAR(wall_stiffness(walls), sum, 1e-6 * sum);  // midpoint rule: 1 / (4 strips^2) relative
}

}  // namespace
}  // namespace coilwright::mechanics
