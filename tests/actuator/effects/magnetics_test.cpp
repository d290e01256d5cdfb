#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {
namespace {

CoilCurrents strength_of(const WithEffect& rig, const CoilCurrents& currents, const Numbers& states,
                         double* slopes = nullptr) {
  CoilCurrents strength = currents;
  rig.term->magnetize({.states = states.data(), .slopes = slopes}, currents, strength);
  return strength;
}

TEST(ForceGain, ScalesEveryCoilsForce) {
  CoilCurrents currents(2);
  currents << 0.7, -1.2;
  const CoilCurrents strength = strength_of(with_effect("force_gain", {0.93}, finger()), currents, {});
  EXPECT_DOUBLE_EQ(strength[0], 0.651);
  EXPECT_DOUBLE_EQ(strength[1], -1.116);
}

TEST(MagnetHeating, WarmsByTheMeanSquareCurrentAndFadesTheForce) {
  constexpr double loss = 0.04;
  constexpr double time_constant = 21.0;
  const WithEffect rig = with_effect("magnet_heating", {loss, time_constant, 1.0}, finger());
  CoilCurrents currents(2);
  currents << 1.4, -0.6;
  const double steady = loss * (1.96 + 0.36) / 2.0;
  for (const double time : {3.0, 21.0, 80.0}) {
    Numbers y(1, 0.0);
    follow(y, time,
           [&](const Numbers& at, Numbers& slope, double) { (void)strength_of(rig, currents, at, &slope[0]); });
    const double share = 1.0 - steady * (1.0 - std::exp(-time / time_constant));
    EXPECT_NEAR(strength_of(rig, currents, y)[1], -0.6 * share, 1e-8);  // integrator: 1e-10 a step
  }
  Numbers settled(1);
  const JointVector still = JointVector::Zero(2);
  rig.term->settle({.chain = rig.spec.chain, .angles = still, .rates = still}, currents, settled.data());
  EXPECT_DOUBLE_EQ(settled[0], steady);
}

TEST(MagnetHeating, NeverTurnsAMagnetRound) {
  const WithEffect rig = with_effect("magnet_heating", {9.0, 5.0, 1.0}, finger());
  EXPECT_EQ(strength_of(rig, CoilCurrents::Constant(2, 1.4), {17.0})[0], 0.0);
  EXPECT_EQ(strength_of(rig, CoilCurrents::Constant(2, 1.4), {-0.1})[0], 1.4);  // an undershoot of a trial step
}

// Torques about the joint of the prototype's pair at 1.4 A by an independent program, N m: noncoaxial.json, "hinge",
// h = 11.5 mm, "edge" (tests/data/magnetics_SOURCES.md).
TEST(OffAxisForce, HasTheTorqueOfTheTiltedPair) {
  const WithEffect rig = with_effect("off_axis_force", {}, finger());
  EXPECT_EQ(rig.term, nullptr);
  struct Case {
    double degrees;
    double torque;
  };
  for (const Case& c : {Case{0.0, 0.024690165689996556}, Case{15.0, 0.013360324684714965},
                        Case{45.0, 0.004915864364137783}, Case{82.5, 0.001775115133805964}}) {
    for (const HingePair& pair : rig.spec.magnetics.hinge_pairs())
      // The curve's tolerance, 1e-6 of its largest value.
      EXPECT_NEAR(1.4 * pair.torque_per_ampere->value(c.degrees * M_PI / 180.0), c.torque, 3e-8) << c.degrees;
  }
  EXPECT_LT(1.4 * finger().magnetics.hinge_pairs()[0].torque_per_ampere->value(M_PI / 4.0), 0.97 * 0.004915);
}

TEST(OffAxisForce, TurnsDistantPairsIntoDipoles) {
  const WithEffect rig = with_effect("off_axis_force", {}, finger(Configuration::C));
  EXPECT_FALSE(rig.spec.magnetics.distant_pairs().empty());
  for (const DistantPair& pair : rig.spec.magnetics.distant_pairs())
    EXPECT_EQ(pair.orientation, DistantPair::Orientation::dipoles);
}

// Straight, 19.8 mm apart, at 1.4 A: 0.0231457 N by Maxwell's loops summed over shells in a separate program; the
// paper's finite elements say 0.024. The arm about each joint is h.
TEST(CoilCoilForce, IsThePapersAndGoesWithTheProductOfTheCurrents) {
  const ModelSpec& nominal = finger();
  const WithEffect rig = with_effect("coil_coil_force", {}, nominal);
  const JointVector straight = JointVector::Zero(2);
  const auto extra = [&](double first, double second) {
    CoilCurrents currents(2);
    currents << first, second;
    JointVector with = JointVector::Zero(2);
    JointVector without = JointVector::Zero(2);
    rig.spec.magnetics.add_torques(rig.spec.chain, straight, currents, with);
    nominal.magnetics.add_torques(nominal.chain, straight, currents, without);
    return JointVector(with - without);
  };
  constexpr double arm = 11.5e-3;
  EXPECT_NEAR(extra(1.4, 1.4)[0], -0.02314567644 * arm, 5e-8 * arm);  // 1e-6 of the curve's largest value
  EXPECT_NEAR(extra(1.4, 1.4)[1], extra(1.4, 1.4)[0], 1e-12);
  EXPECT_NEAR(extra(-1.4, -1.4)[0], extra(1.4, 1.4)[0], 1e-15);
  EXPECT_NEAR(extra(0.7, -1.4)[0], -0.5 * extra(1.4, 1.4)[0], 1e-15);
  EXPECT_EQ(extra(1.4, 0.0)[0], 0.0);
}

// The torque per ampere by another route: what one more ampere in one coil does to the whole model.
TEST(BackEmf, BrakesByTheSquareOfTheTorquePerAmpere) {
  constexpr double conductance = 0.25;
  for (const Configuration configuration : {Configuration::B, Configuration::C, Configuration::D}) {
    const ModelSpec spec = finger(configuration);
    const Model model(spec);
    const int n = model.joints();
    JointVector angles(n);
    JointVector rates(n);
    for (int j = 0; j < n; ++j) angles[j] = 0.31 + 0.1 * std::sin(2.3 * j), rates[j] = 4.0 - 2.9 * j;
    JointVector expected = JointVector::Zero(n);
    for (int c = 0; c < model.coils(); ++c) {
      CoilCurrents one = CoilCurrents::Zero(model.coils());
      one[c] = 1.0;
      const JointVector per_ampere =
          model.torques(angles, rates, one) - model.torques(angles, rates, CoilCurrents::Zero(model.coils()));
      expected -= conductance * per_ampere * per_ampere.dot(rates);
    }
    const WithEffect rig = with_effect("back_emf", {conductance}, spec);
    const JointVector torques = torque_of(rig, angles, rates);
    // Differences of torques of 1e-1 (pulling magnets, contact) lose 1e-17 of 1e-2.
    EXPECT_LT((torques - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LT(torques.dot(rates), 0.0);
    mechanics::JointMatrix damping = mechanics::JointMatrix::Zero(n, n);
    rig.term->add_damping({.chain = spec.chain, .angles = angles, .rates = rates}, CoilCurrents::Zero(model.coils()),
                          damping);
    EXPECT_LT((damping * rates + torques).norm(), 1e-14 * torques.norm() * n);
    EXPECT_EQ(damping, mechanics::JointMatrix(damping.transpose()));
  }
}

TEST(StaticAttraction, FallsWithTheFourthPowerOfTheDistance) {
  constexpr double range = 0.2;
  for (const double side : {-1.0, 1.0}) {
    const WithEffect rig = with_effect("static_attraction", {1.3e-3, range, side}, rotor(1e-3));
    EXPECT_DOUBLE_EQ(torque_of(rig, 0.0, 7.0), 1.3e-3);
    // Twice as far, far off: the matter's own size is worth 2 (c/x)^2 = 2 (1/2 / 20)^2 of it.
    const double near = torque_of(rig, -side * 19.0 * range, 0.0);
    const double far = torque_of(rig, -side * 39.0 * range, 0.0);
    EXPECT_NEAR(near / far, 16.0, 16.0 * 1.25e-3);
    EXPECT_GT(torque_of(rig, side * 0.1, 0.0), 1.3e-3);
    EXPECT_LT(torque_of(rig, -side * 0.1, 0.0), 1.3e-3);
  }
}

// Largest, and level, where the magnet is at the matter.
TEST(StaticAttraction, StaysFiniteAtTheMatter) {
  const WithEffect rig = with_effect("static_attraction", {-1e-3, 0.4, 1.0}, rotor(1e-3));
  EXPECT_NEAR(torque_of(rig, 0.4, 0.0), -25e-3, 1e-15);
  EXPECT_NEAR((torque_of(rig, 0.401, 0.0) - torque_of(rig, 0.399, 0.0)), 0.0, 1e-15);
}

TEST(StaticAttraction, ActsOnTheFirstJointWithoutCurrentAndConservesEnergy) {
  const WithEffect rig = with_effect("static_attraction", {1e-3, 0.5, 1.0}, finger());
  JointVector angles(2);
  angles << 0.2, 0.1;
  const JointVector torques = torque_of(rig, angles, JointVector::Zero(2));
  EXPECT_GT(torques[0], 0.0);
  EXPECT_EQ(torques[1], 0.0);
  angles[1] = 0.9;
  EXPECT_EQ(torque_of(rig, angles, JointVector::Constant(2, 3.0))[0], torques[0]);
}

}  // namespace
}  // namespace coilwright::actuator
