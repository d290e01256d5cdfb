// The simulated finger beside the paper's printed equations, and its events: friction, stops, sampling.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "degree.hpp"
#include "truth/experiments.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/motion.hpp"
#include "truth/random.hpp"
#include "truth/test_motions.hpp"
#include "truth/torque_curves.hpp"

namespace truth {
namespace {

// (9) to (12) of the paper as printed, solved for the accelerations by Cramer's rule.
TEST(Dynamics, HasThePapersMatrices) {
  const Finger f;
  const double l1 = f.half_pitch, l2 = f.second_com, h = f.axis_offset, m1 = f.first_mass, m2 = f.second_mass;
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const State s{.angles = {random.uniform(-0.3, 1.2), random.uniform(-0.3, 1.2)},
                  .rates = {random.uniform(-20, 20), random.uniform(-20, 20)}};
    const auto [t1, t2] = s.angles;
    const auto [w1, w2] = s.rates;
    const double m22 = m2 * (h * h + l2 * l2);
    const double m12 = m2 * (h * h + l2 * l2 + 2 * l1 * l2 * std::cos(t2) + 2 * h * l1 * std::sin(t2));
    const double m11 = m1 * (h * h + l1 * l1) +
                       m2 * (h * h + 4 * l1 * l1 + l2 * l2 + 4 * l1 * l2 * std::cos(t2) + 4 * h * l1 * std::sin(t2));
    const double cross = l1 * m2 * (h * std::cos(t2) - l2 * std::sin(t2));
    const double c1 = f.damping * w1 + 4 * cross * w1 * w2 + 2 * cross * w2 * w2;
    const double c2 = f.damping * w2 - 2 * cross * w1 * w1;
    const double g1 = f.stiffness * t1 + f.gravity * m1 * (-h * std::cos(t1) + l1 * std::sin(t1)) +
                      f.gravity * m2 * (-h * std::cos(t1 + t2) + 2 * l1 * std::sin(t1) + l2 * std::sin(t1 + t2));
    const double g2 = f.stiffness * t2 + f.gravity * m2 * (-h * std::cos(t1 + t2) + l2 * std::sin(t1 + t2));
    const double current = random.uniform(-1.4, 1.4);
    const double q1 = current * curves::line_of_centres(t1) - c1 - g1;
    const double q2 = current * curves::line_of_centres(t2) - c2 - g2;
    const double det = m11 * m22 - m12 * m12;
    const auto ours = accelerations(f, {}, s, current);
    const double scale = (std::abs(q1) + std::abs(q2)) * m11 / det;
    EXPECT_NEAR(ours[0], (m22 * q1 - m12 * q2) / det, 1e-11 * scale);
    EXPECT_NEAR(ours[1], (m11 * q2 - m12 * q1) / det, 1e-11 * scale);
  }
}

TEST(Curves, InterpolateTheirFunctions) {
  for (const double angle : {-0.4, 0.0, 0.123, 0.77, 1.5}) {
    // a cubic spline over steps of half a degree (2 degrees for the exact torque), and of the largest torque
    EXPECT_NEAR(curves::line_of_centres(angle), line_of_centres_torque({}, angle), 1e-7 * 0.025);
    if (angle > -0.1) {
      EXPECT_NEAR(curves::exact(angle), exact_torque({}, angle), 2e-5 * 0.0175);
    }
  }
  constexpr double h = 1e-3;
  for (const auto& at : {std::array{0.1, 0.2}, std::array{0.6, 0.4}, std::array{1.0, 0.9}}) {
    const CoilCoilTorque torque = curves::coil_coil(at[0], at[1]);
    EXPECT_NEAR(torque.first,
                (coil_coil_inductance({}, at[0] + h, at[1]) - coil_coil_inductance({}, at[0] - h, at[1])) / (2 * h),
                1e-3 * std::abs(torque.first));
    EXPECT_NEAR(torque.second,
                (coil_coil_inductance({}, at[0], at[1] + h) - coil_coil_inductance({}, at[0], at[1] - h)) / (2 * h),
                1e-3 * std::abs(torque.second));
  }
}

// The finger sticks permanently, at any angle at which friction can hold it.
TEST(DryFriction, StopsTheFingerAwayFromItsEquilibrium) {
  const UnmodelledEffects effects{.friction = 4e-4};
  const auto angles = simulate({}, effects, release(1.4, 2.0));
  const auto& end = angles.back();
  EXPECT_EQ(end, angles[angles.size() - 200]);  // bit for bit
  const State at_rest{.angles = end, .rates = {0.0, 0.0}};
  // Without friction it would accelerate; the friction torque is M times that acceleration, at most tau_c per joint.
  const auto wants = accelerations({}, {}, at_rest, 0.0);
  EXPECT_GT(std::abs(wants[0]) + std::abs(wants[1]), 1.0);
  const Finger f;
  const double m22 = f.second_mass * (f.axis_offset * f.axis_offset + f.second_com * f.second_com);
  const double m12 =
      m22 + f.second_mass * 2 * f.half_pitch * (f.second_com * std::cos(end[1]) + f.axis_offset * std::sin(end[1]));
  const double m11 = f.first_mass * (f.axis_offset * f.axis_offset + f.half_pitch * f.half_pitch) + 2 * m12 - m22 +
                     f.second_mass * 4 * f.half_pitch * f.half_pitch;
  EXPECT_LE(std::abs(m11 * wants[0] + m12 * wants[1]), effects.friction);
  EXPECT_LE(std::abs(m12 * wants[0] + m22 * wants[1]), effects.friction);
}

// While the finger moves slowly in one direction, Coulomb friction is a constant torque.
TEST(DryFriction, IsAConstantTorqueInOneDirection) {
  const double torque = 2e-4;
  // The lag of the ramp and the oscillation on it: 2 mrad, a seventh of the effect of friction.
  EXPECT_NEAR(bending(simulate({}, {.friction = torque}, ramp(0.2, 0.8, 4.0)).back()), bending_against(torque, 0.8),
              2e-3);
  EXPECT_NEAR(bending(simulate({}, {.friction = torque}, ramp(1.2, 0.4, 4.0)).back()), bending_against(-torque, 0.4),
              2e-3);
  EXPECT_GT(bending(UnmodelledEffects{}, 0.8) - bending_against(torque, 0.8), 0.01);
}

// Penetration p of a joint into its stop: the energy 1/2 k p^2 is less than the work of the coils up to there.
TEST(EndStop, HoldsEitherSide) {
  const double stiffness = 0.6;
  Experiment step = constant(1.4, 2.0);
  step.currents[0] = 0.0;
  const double at_most = std::sqrt(2.0 * 2 * 1.4 * 0.0175 * 0.45 / stiffness);
  const auto highest = [&](const UnmodelledEffects& effects) {
    double angle = 0.0;
    for (const auto& angles : simulate({}, effects, step)) angle = std::max({angle, angles[0], angles[1]});
    return angle;
  };
  const double stopped = highest({.stop_angle = 0.45, .stop_stiffness = stiffness, .stop_side = 1.0});
  EXPECT_GT(stopped, 0.45);
  EXPECT_LT(stopped, 0.45 + at_most);
  EXPECT_LT(stopped, highest({}) - 10.0 * degree);
  const auto lowest = [&](const UnmodelledEffects& effects) {
    double angle = 1.0;
    for (const auto& angles : simulate({}, effects, release(1.4, 1.0))) angle = std::min({angle, angles[0], angles[1]});
    return angle;
  };
  const double caught = lowest({.stop_angle = 0.1, .stop_stiffness = stiffness, .stop_side = -1.0});
  EXPECT_LT(caught, 0.1);
  EXPECT_GT(caught, lowest({}) + 2.0 * degree);
}

TEST(HiddenKinds, ContainEveryIdOfTheFormatAndOutsidersOfWhichSomeAreKept) {
  int ids = 0;
  int outsiders = 0;
  int kept = 0;
  for (const HiddenKind& kind : hidden_kinds()) {
    ++(kind.outsider() ? outsiders : ids);
    kept += kind.standing == Standing::kept ? 1 : 0;
  }
  for (const char* id :
       {"dry_friction",      "quadratic_drag",    "viscoelastic_creep", "hysteresis",     "stiffness_hardening",
        "joint_asymmetry",   "rest_angle",        "end_stop",           "base_tilt",      "added_mass",
        "force_gain",        "coil_lag",          "back_emf",           "coil_heating",   "magnet_heating",
        "driver_saturation", "driver_deadband",   "current_offset",     "off_axis_force", "coil_coil_force",
        "static_attraction", "measurement_delay", "angle_offset",       "angle_scale",    "mount_compliance",
        "mullins_softening", "tracking_lag",      "stribeck_friction",  "backlash"}) {
    EXPECT_FALSE(hidden_kind(id).outsider()) << id;
    --ids;
  }
  EXPECT_EQ(ids, 0);
  EXPECT_GE(outsiders, 8);
  EXPECT_GE(kept, 4);
  EXPECT_EQ(hidden_kind("stribeck_friction").id, "dry_friction");
  EXPECT_THROW((void)hidden_kind("gremlins"), std::invalid_argument);
}

// Twice as many samples of the same input, which halve the longest step of the integrator, change nothing: every
// effect, at a tenth of its bound, under the paper's 2 Hz sine.
TEST(Motion, DoesNotDependOnTheSampling) {
  const PlannedRuns planned = paper_runs();
  const Experiment& sine = planned.fit[6];
  Experiment twice;
  for (std::size_t i = 0; i < sine.times.size(); ++i)
    for (const double later : {0.0, 0.001}) {
      twice.times.push_back(sine.times[i] + later);
      twice.currents.push_back(sine.currents[i]);
    }
  for (const HiddenKind& kind : hidden_kinds()) {
    if (kind.outsider()) continue;  // random events are drawn for each sample
    Random random(11);
    UnmodelledEffects effects;
    kind.draw(random, {.lowest = -0.1, .highest = 0.9}, effects)(effects, 0.1);
    const auto once = simulate({}, effects, sine);
    auto other = simulate({}, effects, twice);
    Trajectory every_second;
    for (std::size_t i = 0; i < other.size(); i += 2) every_second.push_back(other[i]);
    EXPECT_LT(largest_gap(once, every_second), same_motion) << kind.id;
  }
}

}  // namespace
}  // namespace truth
