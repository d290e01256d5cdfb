#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {
namespace {

constexpr double inertia = 6.7e-6;
constexpr double friction = 0.6e-3;

// One joint of `id` carried along `angle(t)` at `rate(t)`: the work that it takes, J, from `from` to `to` seconds.
template <typename Angle, typename Rate>
double work(const WithEffect& rig, double from, double to, Angle&& angle, Rate&& rate) {
  Numbers y(2, 0.0);
  const auto slope = [&](const Numbers& at, Numbers& dy, double time) {
    dy[0] = -torque_of(rig, angle(time), rate(time), &at[1], &dy[1]) * rate(time);
  };
  follow(y, from, slope);
  const double before = y[0];
  follow(y, to - from, [&](const Numbers& at, Numbers& dy, double time) { slope(at, dy, time + from); });
  return y[0] - before;
}

double cycle_work(const WithEffect& rig, double amplitude, double frequency) {
  const double omega = 2.0 * M_PI * frequency;
  return work(
      rig, 1.0 / frequency, 2.0 / frequency, [&](double t) { return amplitude * std::sin(omega * t); },
      [&](double t) { return amplitude * omega * std::cos(omega * t); });
}

// Whoever follows a motion sets the share y of friction: the sign of the rate where a joint slides.
double sliding_torque(const WithEffect& rig, double rate) {
  const double y = std::copysign(1.0, rate);
  double slope = 1.0;
  const double torque = torque_of(rig, 0.2, rate, &y, &slope);
  EXPECT_EQ(slope, 0.0);
  return torque;
}

TEST(DryFriction, OpposesSlidingByOneTorqueAtAnySpeed) {
  const WithEffect rig = with_effect("dry_friction", {friction}, rotor(inertia));
  EXPECT_TRUE(rig.term->holds_joints());
  for (const double rate : {0.02, -0.02, 3.0, -17.0})
    EXPECT_EQ(sliding_torque(rig, rate), std::copysign(friction, -rate));
}

TEST(DryFriction, HoldsAJointWithAnyShareOfItsTorque) {
  const WithEffect rig = with_effect("dry_friction", {friction}, rotor(inertia));
  for (const double y : {-1.0, -0.3, 0.0, 0.77, 1.0}) EXPECT_EQ(torque_of(rig, 0.2, 0.0, &y), -y * friction);
}

constexpr double ratio = 1.45;
constexpr double stribeck_rate = 0.8;

double stribeck(double rate) {
  return friction * (1.0 + (ratio - 1.0) * std::exp(-rate * rate / (stribeck_rate * stribeck_rate)));
}

TEST(StribeckFriction, IsThePlainOneAtRatioOneBitForBit) {
  const WithEffect plain = with_effect("dry_friction", {friction}, rotor(inertia));
  const WithEffect fallen = with_further_numbers("dry_friction", {friction, 1.0, stribeck_rate}, rotor(inertia));
  for (const double rate : {-9.0, -1e-7, 0.3, 2.0})
    EXPECT_EQ(sliding_torque(plain, rate), sliding_torque(fallen, rate));
}

TEST(StribeckFriction, FallsWithTheRateOfSlidingFromWhatItHolds) {
  const WithEffect rig = with_further_numbers("dry_friction", {friction, ratio, stribeck_rate}, rotor(inertia));
  for (const double rate : {0.05, -0.3, 0.8, -1.1, 6.0})
    EXPECT_NEAR(sliding_torque(rig, rate), -std::copysign(stribeck(rate), rate), 1e-15 * friction) << rate;
  const double whole = 1.0;
  EXPECT_NEAR(torque_of(rig, 0.2, 0.0, &whole), -ratio * friction, 1e-15 * friction);
}

constexpr double share = 0.2;

TEST(LoadFriction, OpposesSlidingInProportionToTheDrive) {
  const WithEffect rig = with_effect("load_friction", {share}, rotor(inertia));
  EXPECT_TRUE(rig.term->holds_joints());
  for (const double drive : {0.3e-3, -2e-3, 0.0})
    for (const double rate : {0.02, -3.0, 17.0}) {
      const JointVector angles = JointVector::Zero(1);
      const JointVector rates = JointVector::Constant(1, rate);
      const JointVector applied = JointVector::Constant(1, drive);
      JointVector torques = JointVector::Zero(1);
      const double y = std::copysign(1.0, rate);
      rig.term->add_torques({.chain = rig.spec.chain, .angles = angles, .rates = rates, .applied = &applied},
                            CoilCurrents(), {.states = &y, .slopes = nullptr}, torques);
      EXPECT_DOUBLE_EQ(torques[0], std::copysign(share * std::abs(drive), -rate));
    }
}

// The whole model hands the commanded torque on, and a motor's torque over current.
TEST(LoadFriction, FeelsCommandedTorquesAndCurrentsOfMotors) {
  ModelSpec spec = with_motors(finger());
  spec.effects = {{.kind = standard_effects().find("load_friction"), .values = {share}}};
  const Model with(spec);
  spec.effects.clear();
  const Model without(spec);
  const JointVector angles = JointVector::Constant(2, 0.3);
  const JointVector rates = JointVector::Constant(2, 5.0);
  const CoilCurrents currents = CoilCurrents::Constant(2, 0.7);
  JointVector applied(2);
  applied << 2e-3, -1e-3;
  const Numbers bent(2, 1.0);
  Numbers slopes(2);
  JointVector one(2);
  JointVector other(2);
  with.derivative(angles, rates, bent, currents, applied, one, slopes);
  without.derivative(angles, rates, {}, currents, applied, other, {});
  const JointVector drive = without.magnetic_torques(angles, currents) + applied;
  const JointVector lost = with.chain().mass_matrix(angles) * (other - one);
  for (int j = 0; j < 2; ++j) EXPECT_NEAR(lost[j], share * std::abs(drive[j]), 1e-12) << j;
}

TEST(LoadFriction, IsOfMotorsAlone) {
  const EffectKind& kind = *standard_effects().find("load_friction");
  EXPECT_EQ(kind.inapplicable(finger()).value_or(""), "coil and magnet act across the joint, without a motor's shaft");
  EXPECT_FALSE(kind.inapplicable(with_motors(finger())).has_value());
  EXPECT_FALSE(kind.inapplicable(rotor(inertia)).has_value());
}

TEST(RotorInertia, TurnsWithEveryJointButTheFirst) {
  const WithEffect rig = with_effect("rotor_inertia", {3.1e-6}, with_motors(finger(Configuration::D)));
  EXPECT_EQ(rig.term, nullptr);
  const mechanics::PlanarChain bare = finger(Configuration::D).chain;
  const JointVector angles = JointVector::Constant(bare.joints(), 0.2);
  mechanics::JointMatrix added = rig.spec.chain.mass_matrix(angles) - bare.mass_matrix(angles);
  for (int j = 1; j < bare.joints(); ++j) added(j, j) -= 3.1e-6;
  EXPECT_LT(added.norm(), 1e-17);
  const EffectKind& kind = *standard_effects().find("rotor_inertia");
  EXPECT_EQ(kind.inapplicable(rotor(inertia)).value_or(""), "a rotor at the first joint is the inertia of its link");
  EXPECT_EQ(kind.inapplicable(finger()).value_or(""), "coil and magnet act across the joint, without a motor's shaft");
}

// Closed form of a steady loop between -A and A: 4 a (A - tanh(gamma A) / gamma).
TEST(Hysteresis, HasALoopThatDoesNotDependOnSpeed) {
  constexpr double amplitude = 0.35;
  constexpr double torque = 0.8e-3;
  constexpr double sharpness = 9.0;
  const WithEffect rig = with_effect("hysteresis", {torque, sharpness}, rotor(inertia));
  const double area = 4.0 * torque * (amplitude - std::tanh(sharpness * amplitude) / sharpness);
  // After one cycle the start is forgotten to exp(-4 gamma A) = 3e-6 of the torque.
  for (const double frequency : {0.05, 1.0, 20.0})
    EXPECT_NEAR(cycle_work(rig, amplitude, frequency), area, 1e-5 * area) << frequency;
}

TEST(Hysteresis, IsPassiveAtEveryInstant) {
  constexpr double torque = 0.8e-3;
  constexpr double sharpness = 9.0;
  const WithEffect rig = with_effect("hysteresis", {torque, sharpness}, rotor(inertia));
  for (const double z : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
    for (const double rate : {-12.0, -0.1, 0.0, 0.3, 20.0}) {
      double slope{};
      const double power = -torque_of(rig, 0.2, rate, &z, &slope) * rate;
      EXPECT_GE(power - torque / sharpness * z * slope, -1e-18);
    }
  }
}

}  // namespace
}  // namespace coilwright::actuator
