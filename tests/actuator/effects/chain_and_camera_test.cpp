#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"

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

// A segment lighter than declared, by what a heavier one has more; but never without mass.
TEST(AddedMass, MayBeTakenAway) {
  const ModelSpec bare = finger();
  const ModelSpec light = with_effect("added_mass", {-4.3e-3}, bare).spec;
  const ModelSpec again = with_effect("added_mass", {4.3e-3}, light).spec;
  EXPECT_NEAR(again.chain.link(1).mass, bare.chain.link(1).mass, 1e-17);
  EXPECT_LT(light.chain.mass_matrix(JointVector::Zero(2))(0, 0), bare.chain.mass_matrix(JointVector::Zero(2))(0, 0));
  const ModelSpec lightest = with_effect("added_mass", {-1.0}, bare).spec;
  EXPECT_NEAR(lightest.chain.link(1).mass, 0.05 * bare.chain.link(1).mass, 1e-17);
}

TEST(MeasurementDelay, ShiftsAndChangesNothingElse) {
  const WithEffect rig = with_effect("measurement_delay", {0.0123}, finger());
  EXPECT_EQ(rig.term->delay(), 0.0123);
  EXPECT_EQ(rig.term->observed(0.71), 0.71);
  EXPECT_EQ(rig.term->states(), 0);
}

// A sine comes out smaller by 1/sqrt(1 + (wT)^2) and later by atan(wT), its rate as its slope.
TEST(TrackingLag, IsAFirstOrderFilter) {
  constexpr double time_constant = 0.021;
  constexpr double omega = 47.0;
  const WithEffect rig = with_effect("tracking_lag", {time_constant}, rotor(1e-3));
  Numbers y(1, 0.0);
  const auto show = [&](const Numbers& at, double* slope, double time) {
    ShownMotion out{.angles = JointVector::Constant(1, 0.4 * std::sin(omega * time)),
                    .rates = JointVector::Constant(1, 0.4 * omega * std::cos(omega * time))};
    rig.term->show({.states = at.data(), .slopes = slope}, out.angles, out.rates);
    return out;
  };
  constexpr double end = 40.0 * time_constant;
  follow(y, end, [&](const Numbers& at, Numbers& dy, double time) { (void)show(at, dy.data(), time); });
  const ShownMotion shown = show(y, nullptr, end);
  const double amplitude = 0.4 / std::hypot(1.0, omega * time_constant);
  const double phase = omega * end - std::atan(omega * time_constant);
  EXPECT_NEAR(shown.angles[0], amplitude * std::sin(phase), 1e-8);  // the integrator's 1e-10 a step
  EXPECT_NEAR(shown.rates[0], amplitude * omega * std::cos(phase), 1e-6);
}

// Through the whole model: the effect's slopes are asked for by the equation of motion, the camera sees its states.
TEST(TrackingLag, ShowsTheStatesOfTheModel) {
  ModelSpec spec = finger();
  spec.effects = {{.kind = standard_effects().find("tracking_lag"), .values = {0.03}},
                  {.kind = standard_effects().find("dry_friction"), .values = {0.2e-3}}};
  const Model model(spec);
  ASSERT_EQ(model.internal_states(), 4);
  EXPECT_TRUE(model.camera_filters());
  EXPECT_FALSE(Model(finger()).camera_filters());
  JointVector angles(2);
  angles << 0.3, 0.5;
  JointVector rates(2);
  rates << 2.0, -1.0;
  InternalStates states = model.settled(angles, model.all_coils(0.0));
  EXPECT_EQ(states.tail(2), angles);
  states.tail(2) << 0.27, 0.53;
  const std::span<const double> all(states.data(), 4);
  const ShownMotion shown = model.shown(angles, rates, all);
  EXPECT_EQ(shown.angles[0], 0.27);
  EXPECT_NEAR(shown.rates[0], 1.0, 1e-14);
  EXPECT_NEAR(shown.rates[1], -1.0, 1e-14);
  JointVector accelerations(2);
  Numbers slopes(4);
  model.derivative(angles, rates, all, model.all_coils(0.3), JointVector::Zero(2), accelerations, slopes);
  EXPECT_EQ(slopes[2], shown.rates[0]);
  EXPECT_EQ(slopes[3], shown.rates[1]);
  const ShownMotion plain = Model(finger()).shown(angles, rates, {});
  EXPECT_EQ(plain.angles, angles);
  EXPECT_EQ(plain.rates, rates);
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
