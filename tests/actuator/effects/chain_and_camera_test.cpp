#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/rig.hpp"

namespace coilwright::actuator {
namespace {

// A base turned by phi is a first joint opened by phi that no spring notices.
TEST(BaseTilt, TurnsTheWholeChain) {
  constexpr double tilt = -0.083;
  const ModelSpec level = finger(Configuration::C);
  const ModelSpec turned = with_effect("base_tilt", {tilt}, level).spec;
  JointVector angles(4);
  angles << 0.31, 0.12, -0.02, 0.44;
  JointVector opened = angles;
  opened[0] += tilt;
  const JointVector expected = level.chain.gravity_torques(opened);
  EXPECT_LT((turned.chain.gravity_torques(angles) - expected).norm(), 1e-15 * 16);  // rounding of 1e-2
  EXPECT_LT((turned.chain.mass_matrix(angles) - level.chain.mass_matrix(angles)).norm(), 1e-20);
  for (int j = 0; j < 4; ++j) EXPECT_EQ(turned.hinges[j].torque_offset, level.hinges[j].torque_offset);
}

TEST(BaseTilt, AddsToTheDeclaredOne) {
  const ModelSpec once = with_effect("base_tilt", {0.03}, finger()).spec;
  const ModelSpec twice = with_effect("base_tilt", {0.05}, once).spec;
  EXPECT_DOUBLE_EQ(twice.chain.base_tilt(), 0.08);
}

// The energies that a point mass at the last link's centre of mass has by itself.
TEST(AddedMass, WeighsAndMovesAsAPointAtTheTipSegment) {
  constexpr double mass = 4.3e-3;
  const ModelSpec bare = finger();
  const ModelSpec laden = with_effect("added_mass", {mass}, bare).spec;
  JointVector angles(2);
  angles << 0.4, 0.7;
  JointVector rates(2);
  rates << -3.0, 8.0;
  const mechanics::Link& last = bare.chain.link(1);
  const mechanics::LinkPoint centre{.link = 1, .along = last.com_along, .offset = last.com_offset};
  const Eigen::Vector2d velocity = bare.chain.jacobian(centre, angles) * rates;
  const double height = bare.chain.position(centre, angles).y();
  EXPECT_NEAR(laden.chain.kinetic_energy(angles, rates) - bare.chain.kinetic_energy(angles, rates),
              0.5 * mass * velocity.squaredNorm(), 1e-17);
  EXPECT_NEAR(laden.chain.potential_energy(angles) - bare.chain.potential_energy(angles),
              mass * bare.chain.gravity() * height, 1e-16);
  EXPECT_EQ(laden.chain.link(1).com_along, last.com_along);
  EXPECT_EQ(laden.chain.link(0).mass, bare.chain.link(0).mass);
}

TEST(MeasurementDelay, ShiftsAndChangesNothingElse) {
  const WithEffect rig = with_effect("measurement_delay", {0.0123}, finger());
  EXPECT_EQ(rig.term->delay(), 0.0123);
  EXPECT_EQ(rig.term->observed(0.71), 0.71);
  EXPECT_EQ(rig.term->states(), 0);
}

TEST(AngleScale, ShowsEveryAngleLarger) {
  const WithEffect rig = with_effect("angle_scale", {1.04}, finger());
  EXPECT_DOUBLE_EQ(rig.term->observed(0.5), 0.52);
  EXPECT_DOUBLE_EQ(rig.term->observed(-0.25), -0.26);
  EXPECT_EQ(rig.term->delay(), 0.0);
}

TEST(AngleOffset, ShowsEveryAngleShifted) {
  const WithEffect rig = with_effect("angle_offset", {-0.011}, finger());
  EXPECT_DOUBLE_EQ(rig.term->observed(0.5), 0.489);
  EXPECT_EQ(rig.term->observed(0.0), -0.011);
}

}  // namespace
}  // namespace coilwright::actuator
