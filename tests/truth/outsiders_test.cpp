// What the effects must do that the first catalogue lacks, and the changes of the rig: energy that is kept, or the
// finger without the effect under another current, damping or gravity.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "truth/dynamics.hpp"
#include "truth/motion.hpp"
#include "truth/motion_integrator.hpp"
#include "truth/recording.hpp"
#include "truth/test_motions.hpp"

namespace truth {
namespace {

using std::numbers::pi;

Experiment sine(double mean, double amplitude, double frequency, double duration) {
  Experiment experiment = constant(mean, duration);
  for (std::size_t i = 0; i < experiment.times.size(); ++i)
    experiment.currents[i] += amplitude * std::sin(2.0 * pi * frequency * experiment.times[i]);
  return experiment;
}

// Kinetic energy of the paper's point masses, one more at the tip, and part of the second on a link that is bent
// further; with that of gravity and of the springs. In plain coordinates of each mass.
double energy(const Finger& f, const UnmodelledEffects& effects, const Rig& rig, const StateVector& state) {
  const double bent = effects.bend_share > 0.0 ? state[StateIndex::mount] : 0.0;
  const double bent_rate = effects.bend_share > 0.0 ? state[StateIndex::mount + 1] : 0.0;
  const double first = state[0];
  const double second = first + state[1];
  const double w1 = state[2];
  const double w2 = w1 + state[3];
  const auto mass = [&](double m, double from_joint, double along, double across, double angle, double rate) {
    const double x = from_joint * std::sin(first) + along * std::sin(angle) - across * std::cos(angle);
    const double y = -from_joint * std::cos(first) - along * std::cos(angle) - across * std::sin(angle);
    const double vx = from_joint * std::cos(first) * w1 + (along * std::cos(angle) + across * std::sin(angle)) * rate;
    const double vy = from_joint * std::sin(first) * w1 + (along * std::sin(angle) - across * std::cos(angle)) * rate;
    const double height = y * std::cos(rig.base_turn) + x * std::sin(rig.base_turn);
    return 0.5 * m * (vx * vx + vy * vy) + m * f.gravity * height;
  };
  const double pitch = 2.0 * f.half_pitch;
  const double bending = f.second_mass * effects.bend_share;
  double sum = mass(f.first_mass, 0.0, f.half_pitch, f.axis_offset, first, w1) +
               mass(f.second_mass - bending, pitch, f.second_com, f.axis_offset, second, w2) +
               mass(bending, pitch, f.second_com, f.axis_offset, second + bent, w2 + bent_rate) +
               mass(rig.tip_mass, pitch, f.tip_length, 0.0, second, w2);
  sum += 0.5 * f.stiffness * (state[0] * state[0] + f.second_stiffness_ratio * state[1] * state[1]);
  sum += 0.5 * effects.joint_coupling * std::pow(state[0] - state[1], 2);
  for (const int j : {0, 1}) sum += 0.5 * f.faces.stiffness * std::pow(std::max(f.faces.angle - state[j], 0.0), 2);
  const double arm = f.second_com * f.second_com + f.axis_offset * f.axis_offset;
  sum += 0.5 * bending * arm * std::pow(2.0 * pi * effects.bend_frequency * bent, 2);
  return sum;
}

void expect_energy_kept(const Finger& finger, const UnmodelledEffects& effects, const Rig& rig) {
  Dynamics dynamics(finger, effects, rig);
  const auto start = equilibrium(finger, effects, 1.2, rig);
  MotionIntegrator integrator(dynamics, dynamics.settled({start[0], start[1]}));
  const double at_start = energy(finger, effects, rig, integrator.state());
  double kinetic = 0.0;
  for (int i = 1; i <= 200; ++i) {
    integrator.integrate(0.005 * i);
    const StateVector& state = integrator.state();
    kinetic =
        std::max(kinetic, 0.5 * finger.second_mass * finger.axis_offset * finger.axis_offset * state[2] * state[2]);
    // A thousand steps with 1e-9 of an angle or a rate each, of an energy whose slopes are millijoules at most.
    EXPECT_NEAR(energy(finger, effects, rig, state), at_start, 1e-9);
  }
  EXPECT_GT(kinetic, 1e-5);
}

TEST(Energy, IsKeptWithoutDampingWhateverIsElastic) {
  Finger finger;
  finger.damping = 0.0;
  finger.second_stiffness_ratio = 0.9;
  expect_energy_kept(finger, {}, {});
  expect_energy_kept(finger, {}, {.base_turn = 0.4, .tip_mass = 6e-3});
  expect_energy_kept(finger, {.joint_coupling = 7e-3}, {});
  expect_energy_kept(finger, {.bend_share = 0.4, .bend_frequency = 17.0, .bend_damping = 0.0}, {.tip_mass = 3e-3});
  finger.faces = {.angle = 0.12, .stiffness = 0.2, .damping = 0.0};
  expect_energy_kept(finger, {}, {});
}

TEST(Energy, IsLostToFriction) {
  Finger finger;
  finger.damping = 0.0;
  for (const UnmodelledEffects& effects :
       {UnmodelledEffects{.angle_friction = 2e-3}, UnmodelledEffects{.friction = 1e-4, .stribeck_ratio = 1.6}}) {
    Dynamics dynamics(finger, effects);
    const auto start = equilibrium(finger, {}, 1.2);
    MotionIntegrator integrator(dynamics, dynamics.settled({start[0], start[1]}));
    double before = energy(finger, effects, {}, integrator.state());
    const double at_start = before;
    for (int i = 1; i <= 100; ++i) {
      integrator.integrate(0.005 * i);
      const double now = energy(finger, effects, {}, integrator.state());
      EXPECT_LT(now, before + 1e-9);
      before = now;
    }
    EXPECT_LT(before, at_start - 1e-4);
  }
}

TEST(Segment, BendsUnderItsWeightAsASpringDoes) {
  const UnmodelledEffects bending{.bend_share = 0.5, .bend_frequency = 12.0};
  const Dynamics dynamics({}, bending);
  const StateVector state = dynamics.settled({0.5, 0.4});
  const Finger f;
  const double arm = f.second_com * f.second_com + f.axis_offset * f.axis_offset;
  const double angle = 0.9 + state[StateIndex::mount];
  const double weight = -f.gravity * (f.second_com * std::sin(angle) - f.axis_offset * std::cos(angle));
  EXPECT_NEAR(state[StateIndex::mount], weight / (arm * std::pow(2.0 * pi * 12.0, 2)), 1e-9);
  EXPECT_NE(state[StateIndex::mount], 0.0);
  EXPECT_THROW(Dynamics({}, {.mount_compliance = 0.3, .bend_share = 0.3}), std::invalid_argument);
}

TEST(Stribeck, HoldsWithMoreThanItSlidesWith) {
  const UnmodelledEffects effects{.friction = 2e-4, .stribeck_ratio = 1.8, .stribeck_rate = 0.02};
  const Dynamics dynamics({}, effects);
  EXPECT_DOUBLE_EQ(dynamics.friction_at(0.0), 3.6e-4);
  EXPECT_NEAR(dynamics.friction_at(-0.02), 2e-4 * (1.0 + 0.8 / std::numbers::e), 1e-15);
  EXPECT_NEAR(dynamics.friction_at(5.0), 2e-4, 1e-15);
  // A ramp from rest breaks away where plain friction of the level at rest would.
  const Experiment slow = ramp(0.5, 0.6, 2.0);
  const auto ours = simulate({}, effects, slow);
  const auto plain = simulate({}, {.friction = 3.6e-4}, slow);
  const auto weaker = simulate({}, {.friction = 2e-4}, slow);
  const auto breaks_away = [](const Trajectory& motion) {
    std::size_t i = 0;
    while (i < motion.size() && motion[i] == motion[0]) ++i;
    return i;
  };
  EXPECT_EQ(breaks_away(ours), breaks_away(plain));
  EXPECT_LT(breaks_away(weaker), breaks_away(ours));
  EXPECT_GT(largest_gap(ours, plain), 1e-3);
}

// Across its gap a magnet takes its torque and its inertia with it; on its seat it gives back both.
TEST(Backlash, KeepsTheTorqueFromTheJointWithinTheGap) {
  const UnmodelledEffects loose{.backlash = 0.08, .backlash_inertia = 0.15};
  EXPECT_NEAR(bending(loose, 1.0), bending(UnmodelledEffects{}, 1.0), 1e-12);
  const Finger f;
  const double m22 = f.second_mass * (f.axis_offset * f.axis_offset + f.second_com * f.second_com);
  const auto row = [&](double a2) {
    const double m12 =
        m22 + f.second_mass * 2 * f.half_pitch * (f.second_com * std::cos(a2) + f.axis_offset * std::sin(a2));
    const double m11 = f.first_mass * (f.axis_offset * f.axis_offset + f.half_pitch * f.half_pitch) + 2 * m12 - m22 +
                       f.second_mass * 4 * f.half_pitch * f.half_pitch;
    return std::array{m11, m12};
  };
  const auto [s11, s12] = row(0.0);
  const double determinant = s11 * m22 - s12 * s12;
  const double first = 0.15 * determinant / m22;
  const double second = 0.15 * determinant / s11;
  Dynamics dynamics({}, loose);
  dynamics.input.target = dynamics.input.from = 1.0;
  StateVector state{};
  state[0] = 0.3;
  state[1] = 0.4;
  const auto flying = dynamics.accelerations(state, 0.0);
  const auto falling = accelerations({}, {}, {.angles = {0.3, 0.4}, .rates = {}}, 0.0);  // no current, whole inertia
  const auto [m11, m12] = row(0.4);
  EXPECT_NEAR((m11 - first) * flying[0] + m12 * flying[1], m11 * falling[0] + m12 * falling[1], 1e-12);
  EXPECT_NEAR(m12 * flying[0] + (m22 - second) * flying[1], m12 * falling[0] + m22 * falling[1], 1e-12);
  // Pressed steadily, magnet and joint move as one.
  const auto both = simulate({}, loose, ramp(0.5, 1.2, 2.0));
  const auto one = simulate({}, {}, ramp(0.5, 1.2, 2.0));
  EXPECT_LT(largest_gap(both, one), 1e-4);
  EXPECT_GT(largest_gap(simulate({}, loose, release(1.4, 0.5)), simulate({}, {}, release(1.4, 0.5))), 5e-3);
}

TEST(Tracking, IsAFilterOfTheFirstOrder) {
  const double time = 0.02;
  const Experiment experiment = release(1.4, 0.5);
  const auto shown = simulate({}, {.tracking_time = time}, experiment);
  const auto is = simulate({}, {}, experiment);
  std::array<double, 2> filtered = is[0];
  for (std::size_t i = 1; i < is.size(); ++i)
    for (const int j : {0, 1}) {
      // exact for an angle that is straight between samples; its curvature leaves 600 rad/s^2 * 2 ms * 2 ms / 12
      const double kept = std::exp(-0.002 / time);
      const double slope = (is[i][j] - is[i - 1][j]) / 0.002;
      filtered[j] = is[i][j] - slope * time + kept * (filtered[j] - is[i - 1][j] + slope * time);
      EXPECT_NEAR(shown[i][j], filtered[j], 3e-4);
    }
}

TEST(Iron, WeakensTheCurrentByItsSquare) {
  EXPECT_NEAR(bending({.iron_saturation = 0.2}, 1.0), bending(UnmodelledEffects{}, 0.8), 1e-12);
  EXPECT_NEAR(bending({.iron_saturation = 0.2}, -0.5), bending(UnmodelledEffects{}, -0.45), 1e-12);
}

TEST(Contact, SendsCurrentToTheOtherCoilBeyondItsAngle) {
  const UnmodelledEffects leak{.contact_share = 0.3, .contact_angle = 0.3};
  Finger leaking;
  leaking.force_factor = {0.7, 1.3};
  // 0.3 rad beyond, or before, is ten times the width: 5e-5 of the share.
  const State open{.angles = {0.6, 0.5}, .rates = {}};
  const State closed{.angles = {0.0, 0.5}, .rates = {}};
  for (const int j : {0, 1}) {
    const double beyond = accelerations(leaking, {}, open, 1.0)[j];
    EXPECT_NEAR(accelerations({}, leak, open, 1.0)[j], beyond, 1e-3 * std::abs(beyond));
    const double before = accelerations({}, {}, closed, 1.0)[j];
    EXPECT_NEAR(accelerations({}, leak, closed, 1.0)[j], before, 1e-3 * std::abs(before));
  }
}

TEST(Magnet, LosesItsShareOnceItHasShifted) {
  Experiment shaken = sine(0.7, 0.6, 2.0, 4.0);
  const Experiment hold = constant(1.0, 4.0);
  for (const double time : hold.times) {
    shaken.times.push_back(4.002 + time);
    shaken.currents.push_back(1.0);
  }
  const auto end = simulate({}, {.magnet_shift = 0.1, .shift_travel = 0.2}, shaken).back();
  EXPECT_NEAR(bending(end), bending(UnmodelledEffects{}, 0.9), 1e-6);
}

TEST(Cable, HoldsTheFirstJointUntilItSlips) {
  const UnmodelledEffects cable{.cable_stiffness = 4e-3, .cable_hold = 3e-4};
  Experiment step = constant(0.8, 3.0);
  step.currents[0] = 0.2;
  const auto end = simulate({}, cable, step).back();
  const auto free = equilibrium({}, {}, 0.8);
  EXPECT_NE(end[0], free[0]);
  EXPECT_LT(std::abs(end[0] - free[0]), 3e-4 / Finger{}.stiffness);
  // A small step does not make it slip: it is a spring to where the step began.
  Experiment small = constant(0.21, 3.0);
  small.currents[0] = 0.2;
  const auto from = equilibrium({}, {}, 0.2);
  const auto held = simulate({}, cable, small).back();
  // moment of the cable: as a constant torque -4e-3 (held - from) on the first joint only
  Dynamics dynamics({}, {});
  dynamics.input.target = 0.21;
  const Eigen::Vector2d left = dynamics.static_residual(dynamics.settled({held[0], held[1]}));
  EXPECT_NEAR(left[0], 4e-3 * (held[0] - from[0]), 1e-7);
  EXPECT_NEAR(left[1], 0.0, 1e-7);
}

TEST(Friction, GrowsWithTheBendingOfTheHinge) {
  const State moving{.angles = {0.3, 0.3}, .rates = {4.0, 0.0}};
  Finger damped;
  damped.damping += 2e-3 * 0.3 * std::tanh(4.0 / 0.3) / 4.0;
  const auto ours = accelerations({}, {.angle_friction = 2e-3}, moving, 1.0);
  const auto theirs = accelerations(damped, {}, moving, 1.0);
  for (const int j : {0, 1}) EXPECT_NEAR(ours[j], theirs[j], 1e-9 * std::abs(theirs[j]));
}

// After a long hold at 1.2 A the friction is 1.44 times its coefficient.
TEST(Friction, GrowsWithTheHeatOfTheCoils) {
  const State moving{.angles = {0.3, 0.3}, .rates = {4.0, 0.0}};
  Finger damped;
  damped.damping += 1e-4 * 1.44 * std::tanh(4.0 / 0.3) / 4.0;
  const auto ours = accelerations({}, {.warm_friction = 1e-4}, moving, 1.2);
  const auto theirs = accelerations(damped, {}, moving, 1.2);
  for (const int j : {0, 1}) EXPECT_NEAR(ours[j], theirs[j], 1e-9 * std::abs(theirs[j]));
}

TEST(Gusts, PushAsFarAsTheFingerYields) {
  const double gust = 5e-5;
  const auto motion = simulate({}, {.gust = gust, .gust_time = 1.0, .chance = 4}, constant(0.7, 120.0));
  double sum = 0.0, squares = 0.0;
  for (const auto& angles : motion) {
    sum += bending(angles);
    squares += bending(angles) * bending(angles);
  }
  const auto count = static_cast<double>(motion.size());
  const double spread = std::sqrt(squares / count - std::pow(sum / count, 2));
  // A push on both joints is a rest angle larger by the torque over the stiffness. Sixty independent pushes: a tenth.
  const double yields = std::abs(bending_against(-gust, 0.7) - bending(UnmodelledEffects{}, 0.7));
  EXPECT_NEAR(spread / yields, 1.0, 0.3);
}

// Of a ramp a loop of the second order is late by twice its damping ratio over its natural frequency.
TEST(Driver, RingsAndIsLate) {
  Experiment slow;
  for (int i = 0; i <= 2000; ++i) {
    slow.times.push_back(i / 500.0);
    slow.currents.push_back(0.35 * i / 500.0);
  }
  const auto late = simulate({}, {.ringing_time = 0.02, .ringing_damping = 0.5}, slow);
  const auto prompt = simulate({}, {}, slow);
  EXPECT_NEAR(bending(late[1500]), bending(prompt[1490]), 2e-4);
  // The current of a step overshoots by exp(-pi damping / sqrt(1 - damping^2)) after half a period.
  Dynamics dynamics({}, {.ringing_time = 0.01, .ringing_damping = 0.2});
  dynamics.input.target = 1.0;
  const double root = std::sqrt(1.0 - 0.04);
  EXPECT_NEAR(dynamics.current(pi * 0.01 / root), 1.0 + std::exp(-pi * 0.2 / root), 1e-12);
  EXPECT_NEAR(dynamics.current_slope(pi * 0.01 / root), 0.0, 1e-9);
}

TEST(Camera, HasAParallaxQuadraticInTheAngle) {
  const Experiment step = constant(0.5, 0.01);
  const auto seen = camera_view(Camera::bending_angle, {.parallax = 0.1}, step, {{0.2, 0.3}});
  EXPECT_DOUBLE_EQ(seen[0], 0.5 + 0.1 * 0.25);
}

TEST(Camera, SeesBentFingersLaterWithARollingShutter) {
  const double skew = 0.01;  // s/rad
  Experiment slow = sine(0.7, 0.5, 0.5, 4.0);
  const auto shown = simulate({}, {.shutter_skew = skew}, slow);
  const auto is = simulate({}, {}, slow);
  for (std::size_t i = 500; i + 20 < is.size(); ++i) {
    const double later = 500.0 * skew * bending(is[i]);  // samples
    const auto whole = static_cast<std::size_t>(later);
    const double share = later - static_cast<double>(whole);
    const double expected = (1.0 - share) * bending(is[i + whole]) + share * bending(is[i + whole + 1]);
    EXPECT_NEAR(bending(shown[i]), expected, 2e-4);  // the curvature over 10 ms: 4 rad/s^2 * (10 ms)^2 / 2
  }
}

TEST(Rig, TurnsTheBaseAsATiltDoes) {
  const auto turned = equilibrium({}, {}, 0.7, {.base_turn = 0.3});
  const auto tilted = equilibrium({}, {.base_tilt = 0.3}, 0.7);
  for (const int j : {0, 1}) EXPECT_DOUBLE_EQ(turned[j], tilted[j]);
}

TEST(Rig, OpensAndShortsCoilsWhileNobodyDrives) {
  Experiment free = release(1.2, 1.5);
  const auto with = [&](CoilState coil, const UnmodelledEffects& effects) {
    free.rig.coil = coil;
    return simulate({}, effects, free);
  };
  // A short brakes like a driver without resistance of its own; nothing brakes with coils open.
  const auto shorted = with(CoilState::shorted, {});
  const auto braked = with(CoilState::driven, {.motional_conductance = 0.25});
  EXPECT_LT(largest_gap(shorted, braked), same_motion);
  EXPECT_LT(largest_gap(with(CoilState::open, {.motional_conductance = 0.25}), with(CoilState::driven, {})),
            same_motion);
  EXPECT_GT(largest_gap(shorted, with(CoilState::driven, {})), 0.01);
  // An offset of the driver goes with the driver.
  EXPECT_NEAR(bending(with(CoilState::open, {.current_offset = 0.1}).back()), bending(UnmodelledEffects{}, 0.0), 1e-3);
  EXPECT_NEAR(bending(with(CoilState::driven, {.current_offset = 0.1}).back()), bending(UnmodelledEffects{}, 0.1),
              1e-3);
}

TEST(Faces, PushAJointBackFromTheirAngle) {
  Finger finger;
  finger.faces = {.angle = 0.15, .stiffness = 0.3, .damping = 3e-4};
  double lowest = 1.0;
  for (const auto& angles : simulate(finger, {}, release(1.4, 1.0))) lowest = std::min({lowest, angles[0], angles[1]});
  double alone = 1.0;
  for (const auto& angles : simulate({}, {}, release(1.4, 1.0))) alone = std::min({alone, angles[0], angles[1]});
  EXPECT_LT(lowest, 0.15);
  EXPECT_GT(lowest, alone + 0.02);
  // a unilateral spring and damper on each joint
  const State pressed{.angles = {0.1, 0.4}, .rates = {-2.0, 0.0}};
  const State leaving{.angles = {0.1, 0.4}, .rates = {60.0, 0.0}};
  Finger pushed;
  pushed.force_factor[0] = 0.0;
  Finger faced = pushed;
  faced.faces = finger.faces;
  const double push = 0.3 * 0.05 + 3e-4 * 2.0;
  Dynamics with(faced, {});
  Dynamics without(pushed, {});
  StateVector state{};
  state[0] = 0.1;
  state[1] = 0.4;
  state[2] = -2.0;
  without.input.pull = push;  // on both joints; the faces push the first
  const auto ours = with.accelerations(state, 0.0);
  without.input.pull = 0.0;
  const auto theirs = without.accelerations(state, 0.0);
  const auto inertia = [&](int j) { return ours[j] - theirs[j]; };
  // M (difference) = (push, 0): the second row of the mass matrix says how both accelerations go together
  const Finger f;
  const double m22 = f.second_mass * (f.axis_offset * f.axis_offset + f.second_com * f.second_com);
  const double m12 =
      m22 + f.second_mass * 2 * f.half_pitch * (f.second_com * std::cos(0.4) + f.axis_offset * std::sin(0.4));
  const double m11 = f.first_mass * (f.axis_offset * f.axis_offset + f.half_pitch * f.half_pitch) + 2 * m12 - m22 +
                     f.second_mass * 4 * f.half_pitch * f.half_pitch;
  EXPECT_NEAR(m11 * inertia(0) + m12 * inertia(1), push, 1e-12);
  EXPECT_NEAR(m12 * inertia(0) + m22 * inertia(1), 0.0, 1e-12);
  const auto pulled = accelerations(faced, {}, leaving, 0.0);
  const auto free = accelerations(pushed, {}, leaving, 0.0);
  EXPECT_EQ(pulled, free);  // faces do not pull
  EXPECT_NE(accelerations(faced, {}, pressed, 0.0), accelerations(pushed, {}, pressed, 0.0));
}

}  // namespace
}  // namespace truth
