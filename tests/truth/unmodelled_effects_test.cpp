// What each unmodelled effect must do, by a second route: the finger without the effect under another current, gravity
// or clock.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "degree.hpp"
#include "truth/motion.hpp"
#include "truth/test_motions.hpp"
#include "truth/torque_curves.hpp"

namespace truth {
namespace {

TEST(DriveEffects, ActAsAnotherCurrent) {
  const UnmodelledEffects none;
  EXPECT_NEAR(bending({.deadband = 0.1}, 0.9), bending(none, 0.8), 1e-12);
  EXPECT_NEAR(bending({.deadband = 0.1}, -0.9), bending(none, -0.8), 1e-12);
  EXPECT_NEAR(bending({.deadband = 0.1}, 0.05), bending(none, 0.0), 1e-12);
  EXPECT_NEAR(bending({.saturation = 0.8}, 1.4), bending(none, 0.8), 1e-12);
  EXPECT_NEAR(bending({.current_offset = 0.1}, 0.9), bending(none, 1.0), 1e-12);
  EXPECT_NEAR(bending({.force_gain = 1.1}, 1.0), bending(none, 1.1), 1e-12);
  // The rise x satisfies x (1 + x) = 0.2 at 1 A; the current in the warm coil is 1 / (1 + x).
  const double rise = 0.5 * (std::sqrt(1.8) - 1.0);
  EXPECT_NEAR(bending({.coil_fade = 0.2}, 1.0), bending(none, 1.0 / (1.0 + rise)), 1e-12);
  EXPECT_NEAR(bending({.magnet_loss = 0.05}, 1.2), bending(none, 1.2 * (1.0 - 0.05 * 1.44)), 1e-12);
}

TEST(DriveEffects, HeatUpOverTheirTimeConstant) {
  Experiment hold = constant(1.3, 20.0);
  hold.currents[0] = 0.0;
  const auto angles = simulate({}, {.coil_fade = 0.1, .coil_time = 2.0}, hold);
  EXPECT_NEAR(bending(angles.back()), bending({.coil_fade = 0.1}, 1.3), 1e-4);  // after ten time constants: 5e-5
  EXPECT_NEAR(bending(angles[600]), bending(UnmodelledEffects{}, 1.3), 8.0 * degree);
  EXPECT_GT(bending(angles[600]), bending(angles.back()) + 0.5 * degree);
}

// A lag is a low-pass filter before the finger: for a slow ramp it is a delay by its time constant.
TEST(DriveEffects, LagBehindARampByTheirTimeConstant) {
  Experiment ramp;
  for (int i = 0; i <= 2000; ++i) {
    ramp.times.push_back(i / 500.0);
    ramp.currents.push_back(0.35 * i / 500.0);
  }
  const auto late = simulate({}, {.current_lag = 0.02}, ramp);
  const auto prompt = simulate({}, {}, ramp);
  // 10 samples; a quasi-static motion differs by the curvature of the ramp only.
  EXPECT_NEAR(bending(late[1500]), bending(prompt[1490]), 2e-4);
}

TEST(HingeEffects, BalanceTheTorquesOfTheFingerAtRest) {
  const Finger f;
  const double current = 0.9;
  const auto moment_left = [&](const UnmodelledEffects& q) {
    const auto [t1, t2] = equilibrium(f, q, current);
    const double tilt = q.base_tilt;
    const double m2 = f.second_mass + q.added_mass;
    const double weight2 =
        f.gravity * m2 * (-f.axis_offset * std::cos(t1 + t2 + tilt) + f.second_com * std::sin(t1 + t2 + tilt));
    const double weight1 =
        f.gravity * f.first_mass * (-f.axis_offset * std::cos(t1 + tilt) + f.half_pitch * std::sin(t1 + tilt)) +
        weight2 + f.gravity * m2 * 2 * f.half_pitch * std::sin(t1 + tilt);
    const double spring1 = f.stiffness * (t1 - q.rest_angle + q.hardening * t1 * t1 * t1);
    const double spring2 = f.stiffness * (q.second_stiffness_ratio * (t2 - q.rest_angle + q.hardening * t2 * t2 * t2));
    const double nearness = 1.25 / (std::pow(1.0 - q.attraction_side * t1 / q.attraction_range, 2) + 0.25);
    const double pull = q.attraction * nearness * nearness;
    const auto stop = [&](double angle) { return q.stop_stiffness * std::max(angle - q.stop_angle, 0.0); };
    return std::hypot(current * curves::line_of_centres(t1) + pull - spring1 - weight1 - stop(t1),
                      current * curves::line_of_centres(t2) - spring2 - weight2 - stop(t2));
  };
  for (const UnmodelledEffects& effects :
       {UnmodelledEffects{}, UnmodelledEffects{.hardening = 0.4}, UnmodelledEffects{.second_stiffness_ratio = 1.3},
        UnmodelledEffects{.rest_angle = 0.1}, UnmodelledEffects{.base_tilt = -0.2},
        UnmodelledEffects{.added_mass = 5e-3}, UnmodelledEffects{.stop_angle = 0.4, .stop_stiffness = 0.3},
        UnmodelledEffects{.attraction = 1e-3, .attraction_range = 0.9, .attraction_side = 1.0},
        UnmodelledEffects{.attraction = -1e-3, .attraction_range = 0.7, .attraction_side = -1.0}})
    EXPECT_LT(moment_left(effects), 1e-12);
}

TEST(HingeEffects, CreepMakesHingesStifferAtFirstOnly) {
  const UnmodelledEffects creep{.creep_share = 0.2, .creep_time = 0.5};
  EXPECT_NEAR(bending(creep, 1.4), bending(UnmodelledEffects{}, 1.4), 1e-12);
  Experiment step = constant(1.4, 6.0);
  step.currents[0] = 0.0;
  const auto with = simulate({}, creep, step);
  const auto without = simulate({}, {}, step);
  EXPECT_NEAR(bending(with.back()), bending(without.back()), 1e-5);
  EXPECT_LT(bending(with[100]), bending(without[100]) - 1.0 * degree);
}

// Both ends of the loop: after a long motion in one direction z is 1, whatever the history.
TEST(HingeEffects, HysteresisActsAgainstEitherDirection) {
  const double torque = 3e-4;
  const UnmodelledEffects loop{.hysteresis = torque, .hysteresis_sharpness = 20.0};
  // 0.3 rad per joint is six times 1 / sharpness; the lag of the ramp itself is below a milliradian.
  EXPECT_NEAR(bending(simulate({}, loop, ramp(0.0, 1.0, 8.0)).back()), bending_against(torque, 1.0), 2e-3);
  EXPECT_NEAR(bending(simulate({}, loop, ramp(1.4, 0.2, 8.0)).back()), bending_against(-torque, 0.2), 2e-3);
}

// At one angle motional damping is a damper with the coefficient kappa g^2.
TEST(MagneticEffects, MotionalDampingIsADamper) {
  constexpr double current = 1.0;
  constexpr double conductance = 0.5;
  const auto rest = equilibrium({}, {}, current);
  const State moving{.angles = rest, .rates = {1e-3, 0.0}};
  const double g = curves::line_of_centres(rest[0]);
  Finger damped;
  damped.damping += conductance * g * g;
  const auto ours = accelerations({}, {.motional_conductance = conductance}, moving, current);
  const auto theirs = accelerations(damped, {}, moving, current);
  for (const int j : {0, 1}) EXPECT_NEAR(ours[j], theirs[j], 1e-9 * std::abs(theirs[j]));
}

TEST(ChainEffects, DragGrowsWithTheSquareOfTheRate) {
  const State moving{.angles = {0.3, 0.3}, .rates = {8.0, 0.0}};
  constexpr double drag = 1e-5;
  Finger damped;
  damped.damping += drag * 8.0;
  const auto ours = accelerations({}, {.drag = drag}, moving, 1.0);
  const auto theirs = accelerations(damped, {}, moving, 1.0);
  for (const int j : {0, 1}) EXPECT_NEAR(ours[j], theirs[j], 1e-9 * std::abs(theirs[j]));
}

TEST(CameraEffects, DelayTheMotion) {
  const Experiment experiment = release(1.4, 0.5);
  const auto late = simulate({}, {.delay = 0.006}, experiment);
  const auto now = simulate({}, {}, experiment);
  for (std::size_t i = 3; i < now.size(); ++i)
    for (const int j : {0, 1}) EXPECT_NEAR(late[i][j], now[i - 3][j], same_motion);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(late[i], now[0]);
}

}  // namespace
}  // namespace truth
