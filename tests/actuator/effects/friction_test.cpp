#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {
namespace {

constexpr double inertia = 6.7e-6;
constexpr double friction = 0.6e-3;
// Bristles of 1500 rad/s on this inertia give way by this much before a joint slides, rad.
constexpr double presliding = friction / (1500.0 * 1500.0 * inertia);

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

TEST(DryFriction, OpposesSlidingByOneTorqueAtAnySpeed) {
  const WithEffect rig = with_effect("dry_friction", {friction}, rotor(inertia));
  for (const double rate : {0.02, -0.02, 3.0, -17.0}) {
    Numbers y(1, 0.0);
    follow(y, 1.0, [&](const Numbers& at, Numbers& dy, double) { (void)torque_of(rig, 0.0, rate, &at[0], &dy[0]); });
    EXPECT_NEAR(torque_of(rig, 0.0, rate, &y[0]), std::copysign(friction, -rate), 1e-7 * friction);
  }
}

// Slowly loaded, bristles bend by Dahl's law: torque = tau_c (1 - exp(-angle / delta)).
TEST(DryFriction, HoldsAgainstASmallerTorqueForEver) {
  const WithEffect rig = with_effect("dry_friction", {friction}, rotor(inertia));
  constexpr double share = 0.6;
  constexpr double ramp = 5.0;
  Numbers y(3, 0.0);
  follow(y, ramp, [&](const Numbers& at, Numbers& dy, double time) {
    dy[0] = at[1];
    dy[1] = (share * friction * time / ramp + torque_of(rig, at[0], at[1], &at[2], &dy[2])) / inertia;
  });
  const double bent = -presliding * std::log(1.0 - share);
  EXPECT_NEAR(y[0], bent, 2e-3 * bent);  // the ramp is 1500 times slower than the bristles
  follow_rotor(rig, share * friction, y, 1.0);
  const double there = y[0];
  follow_rotor(rig, share * friction, y, 100.0);
  EXPECT_NEAR(y[0], there, 1e-6);  // of 0.04 mrad; the integrator's 1e-10 a step of some thousands
  EXPECT_NEAR(y[1], 0.0, 1e-6);
}

TEST(DryFriction, LetsALargerTorqueThroughLessItself) {
  const WithEffect rig = with_effect("dry_friction", {friction}, rotor(inertia));
  Numbers y(3, 0.0);
  constexpr double time = 0.5;
  follow_rotor(rig, 1.5 * friction, y, time);
  const double rate = 0.5 * friction / inertia * time;
  // It starts sliding later by what friction lets through before: of the order of 1/1500 s.
  EXPECT_NEAR(y[1], rate, rate * 2.0 / (300.0 * time));
}

// Coulomb's envelope is a straight line: each half swing loses 2 tau_c / k, at any amplitude.
TEST(DryFriction, LetsAFreeSwingDecayLinearly) {
  constexpr double stiffness = 12.5e-3;
  const WithEffect rig = with_effect("dry_friction", {0.1 * friction}, rotor(inertia, stiffness));
  Numbers y = {1.0, 0.0, 0.0};
  std::vector<double> peaks = {1.0};
  double last_rate = 0.0;
  double last_angle = 1.0;
  follow_rotor(rig, 0.0, y, 0.75, [&](const Numbers& at, double) {
    if (last_rate * at[1] < 0.0)
      peaks.push_back(std::abs(last_angle + (at[0] - last_angle) * last_rate / (last_rate - at[1])));
    last_rate = at[1];
    last_angle = at[0];
  });
  ASSERT_GT(peaks.size(), 8u);
  const double step = 2.0 * 0.1 * friction / stiffness;
  // The bristles turn over within 0.1 mrad, and in 0.5 ms of the 72 ms of half a swing.
  for (std::size_t i = 2; i < peaks.size(); ++i) EXPECT_NEAR(peaks[i - 1] - peaks[i], step, 0.02 * step) << i;
}

// What goes in is stored in the bristle, tau_c delta y^2 / 2, or lost; never the other way round.
TEST(DryFriction, IsPassiveAtEveryInstant) {
  std::mt19937_64 random(20240311);
  std::uniform_real_distribution<double> deflection(-1.0, 1.0);
  std::uniform_real_distribution<double> decades(-7.0, 3.0);
  for (int i = 0; i < 20000; ++i) {
    const double torque = friction * std::pow(10.0, decades(random));
    const WithEffect rig = with_effect("dry_friction", {torque}, rotor(inertia));
    const double delta = presliding * torque / friction;
    const double y = deflection(random);
    const double rate = std::copysign(std::pow(10.0, decades(random)), deflection(random));
    double slope{};
    const double power = -torque_of(rig, 0.1, rate, &y, &slope) * rate;
    const double stored = torque * delta * y * slope;
    EXPECT_GE(power - stored, -1e-12 * torque * std::abs(rate)) << torque << ' ' << rate << ' ' << y;
    // A bristle turns back before it breaks.
    double edge_slope{};
    const double edge = std::copysign(1.0, rate);
    (void)torque_of(rig, 0.1, rate, &edge, &edge_slope);
    EXPECT_EQ(edge_slope, 0.0);
  }
}

// 4 A tau_c a cycle, but for twice the presliding distance at each of two ends.
TEST(DryFriction, TakesTheSameWorkFromACycleAtAnySpeed) {
  const WithEffect rig = with_effect("dry_friction", {friction}, rotor(inertia));
  constexpr double amplitude = 0.3;
  for (const double frequency : {0.1, 1.0, 10.0})
    EXPECT_NEAR(cycle_work(rig, amplitude, frequency), 4.0 * amplitude * friction,
                4.0 * amplitude * friction * 2.0 * presliding / amplitude)
        << frequency;
}

TEST(DryFriction, VanishesWithItsTorque) {
  for (const double torque : {1e-6, 1e-9, 1e-12}) {
    const WithEffect rig = with_effect("dry_friction", {torque}, rotor(inertia));
    const double y = -1.0;
    for (const double rate : {1e-9, 0.03, 15.0}) EXPECT_LE(std::abs(torque_of(rig, 0.0, rate, &y)), 3.0 * torque);
  }
}

// However weak the friction, the bristle asks for no shorter steps than 1/r = 0.5 ms and 1/1500 s do.
TEST(DryFriction, CostsNoMoreWhereItIsWeak) {
  for (const double torque : {friction, 1e-3 * friction, 1e-9 * friction}) {
    const WithEffect rig = with_effect("dry_friction", {torque}, rotor(inertia));
    Numbers y = {0.0, 15.0, 0.0};
    int steps = 0;
    namespace odeint = boost::numeric::odeint;
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_dopri5<Numbers>>(1e-9, 1e-7),
        [&](const Numbers& at, Numbers& dy, double) {
          dy[0] = at[1];
          dy[1] = (torque_of(rig, at[0], at[1], &at[2], &dy[2]) - 12.5e-3 * at[0]) / inertia;
        },
        y, 0.0, 1.0, 1e-4, [&](const Numbers&, double) { ++steps; });
    EXPECT_LT(steps, 6000) << torque;
  }
}

constexpr double ratio = 1.45;
constexpr double stribeck_rate = 0.8;

double stribeck(double rate) {
  return friction * (1.0 + (ratio - 1.0) * std::exp(-rate * rate / (stribeck_rate * stribeck_rate)));
}

TEST(StribeckFriction, IsThePlainOneAtRatioOneBitForBit) {
  const WithEffect plain = with_effect("dry_friction", {friction}, rotor(inertia));
  const WithEffect fallen = with_further_numbers("dry_friction", {friction, 1.0, stribeck_rate}, rotor(inertia));
  std::mt19937_64 random(20240312);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double y = any(random);
    const double rate = std::pow(10.0, 4.0 * any(random)) * any(random);
    double slope{};
    double other{};
    EXPECT_EQ(torque_of(plain, 0.2, rate, &y, &slope), torque_of(fallen, 0.2, rate, &y, &other));
    EXPECT_EQ(slope, other);
  }
}

TEST(StribeckFriction, FallsWithTheRateOfSliding) {
  const WithEffect rig = with_further_numbers("dry_friction", {friction, ratio, stribeck_rate}, rotor(inertia));
  for (const double rate : {0.05, -0.3, 0.8, -1.1, 6.0}) {
    Numbers y(1, 0.0);
    follow(y, 3.0, [&](const Numbers& at, Numbers& dy, double) { (void)torque_of(rig, 0.0, rate, &at[0], &dy[0]); });
    EXPECT_NEAR(torque_of(rig, 0.0, rate, &y[0]), -std::copysign(stribeck(rate), rate), 1e-7 * friction) << rate;
  }
}

// A slow load is held up to the static friction, and no further.
TEST(StribeckFriction, HoldsItsStaticTorque) {
  const WithEffect rig = with_further_numbers("dry_friction", {friction, ratio, stribeck_rate}, rotor(inertia));
  const auto loaded = [&](double share) {
    Numbers y(3, 0.0);
    constexpr double ramp = 5.0;
    follow(y, ramp, [&](const Numbers& at, Numbers& dy, double time) {
      dy[0] = at[1];
      dy[1] = (share * friction * time / ramp + torque_of(rig, at[0], at[1], &at[2], &dy[2])) / inertia;
    });
    return y[0];
  };
  // Bristles that break at rho bend by -rho delta ln(1 - share/rho).
  const double held = -ratio * presliding * std::log(1.0 - 1.3 / ratio);
  EXPECT_NEAR(loaded(1.3), held, 1e-2 * held);  // the ramp's creep, and exp(-(w/w_s)^2) below 1
  EXPECT_GT(loaded(1.6), 1.0);
}

TEST(StribeckFriction, IsPassiveAtEveryInstantUpToItsBound) {
  std::mt19937_64 random(20240313);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::uniform_real_distribution<double> decades(-7.0, 3.0);
  for (int i = 0; i < 40000; ++i) {
    const double torque = friction * std::pow(10.0, decades(random));
    const double rho = i % 4 == 0 ? 3.0 : 2.0 + any(random);
    const double fall = std::pow(10.0, 2.0 * any(random));
    const WithEffect rig = with_further_numbers("dry_friction", {torque, rho, fall}, rotor(inertia));
    const double delta = presliding * torque / friction;
    const double y = rho * (i % 3 == 0 ? std::copysign(1.0, any(random)) : any(random));
    const double rate = std::copysign(std::pow(10.0, decades(random)), any(random));
    double slope{};
    const double power = -torque_of(rig, 0.1, rate, &y, &slope) * rate;
    EXPECT_GE(power - torque * delta * y * slope, -1e-12 * torque * std::abs(rate))
        << torque << ' ' << rho << ' ' << fall << ' ' << rate << ' ' << y;
    // It never bends further than it breaks at rest.
    const double edge = std::copysign(rho, rate);
    double edge_slope{};
    (void)torque_of(rig, 0.1, rate, &edge, &edge_slope);
    EXPECT_LE(edge_slope * edge, 1e-9 * std::abs(rate) / delta);  // rounding of w - |w|
  }
}

constexpr double share = 0.2;

// Of one joint under the torque `drive` of its motor, N m.
double load_torque(const WithEffect& rig, double drive, double rate, const double* state, double* slope) {
  const JointVector angles = JointVector::Zero(1);
  const JointVector rates = JointVector::Constant(1, rate);
  const JointVector applied = JointVector::Constant(1, drive);
  JointVector torques = JointVector::Zero(1);
  rig.term->add_torques({.chain = rig.spec.chain, .angles = angles, .rates = rates, .applied = &applied},
                        CoilCurrents(), {.states = state, .slopes = slope}, torques);
  return torques[0];
}

TEST(LoadFriction, OpposesSlidingInProportionToTheDrive) {
  const WithEffect rig = with_effect("load_friction", {share}, rotor(inertia));
  for (const double drive : {0.3e-3, -2e-3})
    for (const double rate : {0.02, -3.0, 17.0}) {
      Numbers y(1, 0.0);
      follow(y, 1.0,
             [&](const Numbers& at, Numbers& dy, double) { (void)load_torque(rig, drive, rate, &at[0], &dy[0]); });
      const double sliding = share * std::abs(drive);
      EXPECT_NEAR(load_torque(rig, drive, rate, &y[0], nullptr), std::copysign(sliding, -rate), 1e-7 * sliding);
      // Without a drive it rubs at once no more.
      EXPECT_EQ(load_torque(rig, 0.0, rate, &y[0], nullptr), 0.0);
    }
}

// A motor holds what lies between 1 - mu and 1 + mu of its torque, and moves what does not with the rest.
TEST(LoadFriction, HoldsALoadNearTheDrivesTorqueAndMovesAnyOther) {
  const WithEffect rig = with_effect("load_friction", {share}, rotor(inertia));
  constexpr double drive = 1e-3;
  const auto rate_after = [&](double load, double time) {
    Numbers y(3, 0.0);
    follow(y, time, [&](const Numbers& at, Numbers& dy, double) {
      dy[0] = at[1];
      dy[1] = (drive - load + load_torque(rig, drive, at[1], &at[2], &dy[2])) / inertia;
    });
    return y[1];
  };
  for (const double held : {0.81, 0.9, 1.1, 1.19}) EXPECT_NEAR(rate_after(held * drive, 1.0), 0.0, 1e-6) << held;
  for (const double moved : {0.7, 1.3}) {
    const double left = (1.0 - moved + (moved < 1.0 ? -share : share)) * drive;
    // It slides once its bristles have bent, some 1/1500 s late.
    EXPECT_NEAR(rate_after(moved * drive, 0.5), left / inertia * 0.5, 5e-3 * std::abs(left) / inertia * 0.5) << moved;
  }
}

TEST(LoadFriction, IsPassiveUnderASteadyDrive) {
  std::mt19937_64 random(20240317);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::uniform_real_distribution<double> decades(-7.0, 3.0);
  for (int i = 0; i < 20000; ++i) {
    const double drive = friction / share * std::pow(10.0, decades(random));
    const WithEffect rig = with_effect("load_friction", {share}, rotor(inertia));
    const double delta = presliding * share * drive / friction;
    const double y = any(random);
    const double rate = std::copysign(std::pow(10.0, decades(random)), any(random));
    double slope{};
    const double power = -load_torque(rig, drive, rate, &y, &slope) * rate;
    EXPECT_GE(power - share * drive * delta * y * slope, -1e-12 * share * drive * std::abs(rate)) << drive << ' ' << y;
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
