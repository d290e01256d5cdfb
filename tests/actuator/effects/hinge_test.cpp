#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {
namespace {

constexpr double segment_inertia = 6.7e-6;
constexpr double stiffness = 12.5e-3;

TEST(JointAsymmetry, ScalesEverySecondSpringOnly) {
  const ModelSpec nominal = finger(Configuration::D);
  const WithEffect rig = with_effect("joint_asymmetry", {1.17}, nominal);
  ASSERT_EQ(nominal.hinges.size(), 5u);
  for (const int j : {0, 2, 4}) EXPECT_EQ(rig.spec.hinges[j].stiffness, nominal.hinges[j].stiffness);
  for (const int j : {1, 3}) {
    EXPECT_DOUBLE_EQ(rig.spec.hinges[j].stiffness, 1.17 * nominal.hinges[0].stiffness);
    EXPECT_EQ(rig.spec.hinges[j].damping, nominal.hinges[j].damping);
  }
}

TEST(RestAngle, IsWhereAJointStaysByItself) {
  constexpr double angle = 0.061;
  const Model model(with_effect("rest_angle", {angle}, rotor(segment_inertia, stiffness)).spec);
  const auto residual = [&](double at) {
    return model.static_residual(JointVector::Constant(1, at), CoilCurrents::Zero(0))[0];
  };
  EXPECT_NEAR(residual(angle), 0.0, 1e-18);  // rounding of 8e-4
  EXPECT_NEAR(residual(0.5) - residual(0.2), -0.3 * stiffness, 1e-17);
}

// Duffing's period in closed form: 4 K(m) / sqrt(w0^2 (1 + beta A^2)), m = beta A^2 / (2 (1 + beta A^2)).
TEST(StiffnessHardening, ShortensTheSwingWithItsAmplitude) {
  constexpr double beta = 1.3;
  const WithEffect rig = with_effect("stiffness_hardening", {beta}, rotor(segment_inertia, stiffness));
  for (const double amplitude : {0.2, 0.9}) {
    const double square = beta * amplitude * amplitude;
    const double modulus = std::sqrt(square / (2.0 * (1.0 + square)));
    const double period = 4.0 * std::comp_ellint_1(modulus) / std::sqrt(stiffness / segment_inertia * (1.0 + square));
    Numbers y = {amplitude, 0.0};
    follow_rotor(rig, 0.0, y, 3.0 * period);
    EXPECT_NEAR(y[0], amplitude, 1e-6);
    EXPECT_NEAR(y[1], 0.0, 1e-5);  // of a peak rate of 40 rad/s
  }
}

TEST(StiffnessHardening, NeverLetsGoWhereItSoftens) {
  constexpr double beta = -0.3;
  const WithEffect rig = with_effect("stiffness_hardening", {beta}, rotor(segment_inertia, stiffness));
  const auto whole = [&](double angle) { return torque_of(rig, angle, 0.0) - stiffness * angle; };
  EXPECT_NEAR(whole(0.6), -stiffness * 0.6 * (1.0 - 0.3 * 0.36), 1e-17);
  const double turn = 1.0 / std::sqrt(0.9);
  const double largest = 2.0 / 3.0 * stiffness * turn;
  for (const double angle : {turn, 1.3, 2.9}) {
    EXPECT_NEAR(whole(angle), -largest, 1e-16);
    EXPECT_NEAR(whole(-angle), largest, 1e-16);
  }
}

TEST(ViscoelasticCreep, RelaxesAfterAStepWithItsTimeConstant) {
  constexpr double ratio = 0.35;
  constexpr double time_constant = 0.7;
  constexpr double step = 0.4;
  const WithEffect rig = with_effect("viscoelastic_creep", {ratio, time_constant}, rotor(segment_inertia, stiffness));
  const JointVector before = JointVector::Constant(1, 0.15);
  const JointVector still = JointVector::Zero(1);
  Numbers y(1);
  rig.term->settle({.chain = rig.spec.chain, .angles = before, .rates = still}, CoilCurrents::Zero(0), y.data());
  EXPECT_EQ(torque_of(rig, 0.15, 0.0, y.data()), 0.0);
  EXPECT_NEAR(torque_of(rig, 0.15 + step, 0.0, y.data()), -ratio * stiffness * step, 1e-17);
  follow(y, 1.1,
         [&](const Numbers& at, Numbers& dy, double) { (void)torque_of(rig, 0.15 + step, 0.0, at.data(), dy.data()); });
  EXPECT_NEAR(torque_of(rig, 0.15 + step, 0.0, y.data()), -ratio * stiffness * step * std::exp(-1.1 / time_constant),
              1e-9 * stiffness);
}

// Loss modulus of the standard linear solid: kappa k w T / (1 + (w T)^2); a cycle takes pi A^2 times that.
TEST(ViscoelasticCreep, TakesTheWorkOfItsLossModulusFromACycle) {
  constexpr double ratio = 0.35;
  constexpr double time_constant = 0.05;
  constexpr double amplitude = 0.3;
  const WithEffect rig = with_effect("viscoelastic_creep", {ratio, time_constant}, rotor(segment_inertia, stiffness));
  for (const double omega : {4.0, 20.0, 90.0}) {
    const auto slope = [&](const Numbers& at, Numbers& dy, double time) {
      const double rate = amplitude * omega * std::cos(omega * time);
      dy[1] = -torque_of(rig, amplitude * std::sin(omega * time), rate, &at[0], &dy[0]) * rate;
    };
    const double period = 2.0 * M_PI / omega;
    Numbers y(2, 0.0);
    follow(y, std::ceil(1.5 / period) * period, slope);  // 30 time constants forget the start
    const double before = y[1];
    follow(y, period, slope);
    const double product = omega * time_constant;
    const double expected = M_PI * amplitude * amplitude * ratio * stiffness * product / (1.0 + product * product);
    EXPECT_NEAR(y[1] - before, expected, 1e-6 * expected) << omega;
  }
}

TEST(ViscoelasticCreep, IsSlowWhereAStepIsOverBefore) {
  EXPECT_TRUE(with_effect("viscoelastic_creep", {0.3, 15.0}, rotor(segment_inertia, stiffness)).term->slow());
  EXPECT_FALSE(with_effect("viscoelastic_creep", {0.3, 0.2}, rotor(segment_inertia, stiffness)).term->slow());
}

// J w' = -c w^2 from w0: w0 / (1 + c w0 t / J).
TEST(QuadraticDrag, SlowsAFreeRotorHyperbolically) {
  constexpr double drag = 3e-7;
  const WithEffect rig = with_effect("quadratic_drag", {drag}, rotor(segment_inertia));
  for (const double start : {20.0, -4.0}) {
    Numbers y = {0.0, start};
    follow_rotor(rig, 0.0, y, 2.5);
    EXPECT_NEAR(y[1], start / (1.0 + drag * std::abs(start) * 2.5 / segment_inertia), 1e-7);
  }
}

TEST(EndStop, PushesOnlyBeyondItsAngleAndAwayFromIt) {
  for (const double side : {-1.0, 1.0}) {
    const WithEffect rig = with_effect("end_stop", {0.4, 0.9, side}, rotor(segment_inertia));
    EXPECT_EQ(torque_of(rig, 0.4 - side * 1e-9, side * 5.0), 0.0);
    EXPECT_NEAR(torque_of(rig, 0.4 + side * 0.01, 0.0), -side * 0.9 * 0.01, 1e-16);
    EXPECT_EQ(torque_of(rig, 0.4 + side * 0.01, -side * 50.0), 0.0);  // leaves faster than the stop can follow
    EXPECT_LT(side * torque_of(rig, 0.4 + side * 0.01, side * 1.0), -0.9 * 0.01);
  }
}

// A linear spring and damper that never pull: the speed after over before is exp(-zeta phi / sqrt(1 - zeta^2)) with
// phi = pi - asin(2 zeta sqrt(1 - zeta^2)), for zeta < 1/sqrt(2).
TEST(EndStop, ReboundsWithTheSpeedOfItsDampingRatio) {
  constexpr double zeta = 0.3;
  const double root = std::sqrt(1.0 - zeta * zeta);
  const double expected = std::exp(-zeta / root * (M_PI - std::asin(2.0 * zeta * root)));
  for (const double side : {-1.0, 1.0}) {
    const WithEffect rig = with_effect("end_stop", {0.1, 0.9, side}, rotor(segment_inertia));
    Numbers y = {0.1 - side * 0.05, side * 3.0};
    follow_rotor(rig, 0.0, y, 0.1);
    EXPECT_NEAR(y[1], -side * 3.0 * expected, 1e-5);
    EXPECT_LT(side * y[0], side * 0.1);
  }
}

TEST(EndStop, DampsSmallMotionsWhereItIsPressed) {
  const WithEffect rig = with_effect("end_stop", {0.4, 0.9, 1.0}, rotor(segment_inertia));
  const auto damping = [&](double angle) {
    mechanics::JointMatrix out = mechanics::JointMatrix::Zero(1, 1);
    const JointVector angles = JointVector::Constant(1, angle);
    const JointVector still = JointVector::Zero(1);
    rig.term->add_damping({.chain = rig.spec.chain, .angles = angles, .rates = still}, CoilCurrents::Zero(0), out);
    return out(0, 0);
  };
  EXPECT_EQ(damping(0.39), 0.0);
  EXPECT_DOUBLE_EQ(damping(0.41), 2.0 * 0.3 * std::sqrt(0.9 * segment_inertia));
}

TEST(EndStop, IsNoStifferThanAnyCameraCouldTell) {
  const double cap = 5e3 * 5e3 * segment_inertia;
  const WithEffect rig = with_effect("end_stop", {0.4, 1e9, 1.0}, rotor(segment_inertia));
  EXPECT_NEAR(torque_of(rig, 0.41, 0.0), -0.01 * cap, 1e-12 * cap);
}

constexpr double mullins_stiffness = 12.5e-3;
constexpr double mullins_angle = 0.23;
constexpr double mullins_softening = 0.17;

// Work that the effect takes from a slow swing to A and back, J, and the torque there.
struct Swing {
  double work{};
  double torque{};
};
Swing slow_swing(const WithEffect& rig, Numbers& y, double amplitude) {
  y[0] = 0.0;
  constexpr double duration = 40.0;
  const auto angle = [&](double time) { return amplitude * std::sin(M_PI * time / duration); };
  const auto rate = [&](double time) { return amplitude * M_PI / duration * std::cos(M_PI * time / duration); };
  follow(y, duration, [&](const Numbers& at, Numbers& dy, double time) {
    dy[0] = -torque_of(rig, angle(time), rate(time), &at[1], &dy[1]) * rate(time);
  });
  return {.work = y[0], .torque = torque_of(rig, amplitude, 0.0, &y[1])};
}

// The first stretch to A follows the falling stiffness, the way back a straight line: what lies between is lost once.
TEST(MullinsSoftening, LosesWorkInTheFirstStretchOnly) {
  const WithEffect rig =
      with_effect("mullins_softening", {mullins_softening, mullins_angle}, rotor(6.7e-6, mullins_stiffness));
  constexpr double a = 0.41;
  constexpr double x = a / mullins_angle;
  const double left = std::exp(-x);
  // Integral of k d theta (exp(-theta/theta_0) - exp(-A/theta_0)) from 0 to A.
  const double lost = mullins_stiffness * mullins_softening *
                      (mullins_angle * mullins_angle * (1.0 - left * (1.0 + x)) - 0.5 * a * a * left);
  Numbers y(2, 0.0);
  const Swing first = slow_swing(rig, y, a);
  EXPECT_NEAR(first.work, lost, 2e-3 * lost);  // the largest angle lags by 1 ms of 20 s
  EXPECT_NEAR(first.torque, mullins_stiffness * mullins_softening * a * (1.0 - left), 1e-12);
  EXPECT_NEAR(slow_swing(rig, y, a).work, 0.0, 1e-4 * lost);
  EXPECT_NEAR(slow_swing(rig, y, -a).work, 0.0, 1e-4 * lost);  // either way
  EXPECT_GT(slow_swing(rig, y, 1.3 * a).work, 0.05 * lost);    // further than ever
}

TEST(MullinsSoftening, KnowsWhatItWasStretchedBefore) {
  const WithEffect rig = with_further_numbers("mullins_softening", {mullins_softening, mullins_angle, 0.5},
                                              rotor(6.7e-6, mullins_stiffness));
  const JointVector still = JointVector::Zero(1);
  Numbers y(2, 0.0);
  rig.term->begin({.chain = rig.spec.chain, .angles = still, .rates = still}, {}, &y[1]);
  EXPECT_EQ(y[1], 0.5);
  EXPECT_NEAR(slow_swing(rig, y, 0.41).work, 0.0, 1e-10);  // the integrator's, a step
  EXPECT_EQ(y[1], 0.5);
  slow_swing(rig, y, 0.6);
  EXPECT_NEAR(y[1], 0.6, 1e-5);
}

// With the energy k theta^2 (1 - D)/2 of the whole spring nothing is won at any state.
TEST(MullinsSoftening, IsPassiveAtEveryInstant) {
  const WithEffect rig =
      with_effect("mullins_softening", {mullins_softening, mullins_angle}, rotor(6.7e-6, mullins_stiffness));
  for (const double angle : {-0.7, -0.1, 0.0, 0.3, 0.9}) {
    for (const double largest : {0.0, 0.1, 0.5, 1.0}) {
      for (const double rate : {-9.0, -0.2, 0.4, 12.0}) {
        double slope{};
        const double power = (mullins_stiffness * angle - torque_of(rig, angle, rate, &largest, &slope)) * rate;
        const double left = 1.0 - mullins_softening * (1.0 - std::exp(-largest / mullins_angle));
        const double fall = mullins_softening / mullins_angle * std::exp(-largest / mullins_angle);
        const double stored = mullins_stiffness * (angle * rate * left - 0.5 * angle * angle * fall * slope);
        EXPECT_GE(power - stored, -1e-16);
        EXPECT_GE(slope, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace coilwright::actuator
