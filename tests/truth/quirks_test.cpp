// What each quirk must do, by a second route: the paper's printed matrices, or the finger without it under another
// current, gravity or clock.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "truth/experiments.hpp"
#include "truth/hidden.hpp"
#include "truth/motion.hpp"
#include "truth/random.hpp"
#include "truth/torque_curves.hpp"

namespace truth {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// The integrator keeps 1e-9 a step; over a thousand steps of a damped motion that stays below this, rad.
constexpr double same_motion = 1e-6;

Experiment constant(double current, double duration) {
  Experiment experiment;
  for (int i = 0; i <= duration * 500; ++i) {
    experiment.times.push_back(i / 500.0);
    experiment.currents.push_back(current);
  }
  return experiment;
}

Experiment release(double current, double duration) {
  Experiment experiment = constant(0.0, duration);
  experiment.currents[0] = current;
  return experiment;
}

double bending(const std::array<double, 2>& angles) {
  return angles[0] + angles[1];
}

double bending(const Quirks& quirks, double current) {
  return bending(equilibrium({}, quirks, current));
}

double largest_gap(const Record& a, const Record& b) {
  double gap = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const int j : {0, 1}) gap = std::max(gap, std::abs(a[i][j] - b[i][j]));
  return gap;
}

// (9) to (12) of the paper as printed, solved for the accelerations by Cramer's rule.
TEST(Dynamics, IsThePapersMatrices) {
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

TEST(Curves, AreWhatTheyTabulate) {
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

TEST(DriveQuirks, AreOtherCurrents) {
  const Quirks none;
  EXPECT_NEAR(bending({.deadband = 0.1}, 0.9), bending(none, 0.8), 1e-12);
  EXPECT_NEAR(bending({.deadband = 0.1}, -0.9), bending(none, -0.8), 1e-12);
  EXPECT_NEAR(bending({.deadband = 0.1}, 0.05), bending(none, 0.0), 1e-12);
  EXPECT_NEAR(bending({.saturation = 0.8}, 1.4), bending(none, 0.8), 1e-12);
  EXPECT_NEAR(bending({.current_offset = 0.1}, 0.9), bending(none, 1.0), 1e-12);
  EXPECT_NEAR(bending({.force_gain = 1.1}, 1.0), bending(none, 1.1), 1e-12);
  // rise x (1 + x) = 0.2 at 1 A; then the warm coil takes 1 / (1 + x)
  const double rise = 0.5 * (std::sqrt(1.8) - 1.0);
  EXPECT_NEAR(bending({.coil_fade = 0.2}, 1.0), bending(none, 1.0 / (1.0 + rise)), 1e-12);
  EXPECT_NEAR(bending({.magnet_loss = 0.05}, 1.2), bending(none, 1.2 * (1.0 - 0.05 * 1.44)), 1e-12);
}

TEST(DriveQuirks, HeatUpOverTheirTimeConstant) {
  Experiment hold = constant(1.3, 20.0);
  hold.currents[0] = 0.0;
  const auto angles = record({}, {.coil_fade = 0.1, .coil_time = 2.0}, hold);
  EXPECT_NEAR(bending(angles.back()), bending({.coil_fade = 0.1}, 1.3), 1e-4);  // ten time constants: 5e-5 is left
  EXPECT_NEAR(bending(angles[600]), bending(Quirks{}, 1.3), 8.0 * degree);
  EXPECT_GT(bending(angles[600]), bending(angles.back()) + 0.5 * degree);
}

// A lag is a low pass before a finger: for a slow ramp it is a delay by its time constant.
TEST(DriveQuirks, LagBehindARampByTheirTimeConstant) {
  Experiment ramp;
  for (int i = 0; i <= 2000; ++i) {
    ramp.times.push_back(i / 500.0);
    ramp.currents.push_back(0.35 * i / 500.0);
  }
  const auto late = record({}, {.current_lag = 0.02}, ramp);
  const auto straight = record({}, {}, ramp);
  // 10 samples; a quasi-static motion differs by the ramp's curvature only
  EXPECT_NEAR(bending(late[1500]), bending(straight[1490]), 2e-4);
}

TEST(HingeQuirks, BalanceTheMomentOfTheFingerAtRest) {
  const Finger f;
  const double current = 0.9;
  const auto moment_left = [&](const Quirks& q) {
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
    const double closeness = 1.25 / (std::pow(1.0 - q.attraction_side * t1 / q.attraction_range, 2) + 0.25);
    const double pull = q.attraction * closeness * closeness;
    const auto stop = [&](double angle) { return q.stop_stiffness * std::max(angle - q.stop_angle, 0.0); };
    return std::hypot(current * curves::line_of_centres(t1) + pull - spring1 - weight1 - stop(t1),
                      current * curves::line_of_centres(t2) - spring2 - weight2 - stop(t2));
  };
  for (const Quirks& quirks :
       {Quirks{}, Quirks{.hardening = 0.4}, Quirks{.second_stiffness_ratio = 1.3}, Quirks{.rest_angle = 0.1},
        Quirks{.base_tilt = -0.2}, Quirks{.added_mass = 5e-3}, Quirks{.stop_angle = 0.4, .stop_stiffness = 0.3},
        Quirks{.attraction = 1e-3, .attraction_range = 0.9, .attraction_side = 1.0},
        Quirks{.attraction = -1e-3, .attraction_range = 0.7, .attraction_side = -1.0}})
    EXPECT_LT(moment_left(quirks), 1e-12);
}

TEST(HingeQuirks, CreepHingesAreStifferAtFirstOnly) {
  const Quirks creep{.creep_share = 0.2, .creep_time = 0.5};
  EXPECT_NEAR(bending(creep, 1.4), bending(Quirks{}, 1.4), 1e-12);
  Experiment step = constant(1.4, 6.0);
  step.currents[0] = 0.0;
  const auto with = record({}, creep, step);
  const auto without = record({}, {}, step);
  EXPECT_NEAR(bending(with.back()), bending(without.back()), 1e-5);
  EXPECT_LT(bending(with[100]), bending(without[100]) - 1.0 * degree);
}

Experiment ramp(double from, double to, double duration) {
  Experiment experiment;
  const int samples = static_cast<int>(duration * 500);
  for (int i = 0; i <= samples; ++i) {
    experiment.times.push_back(i / 500.0);
    experiment.currents.push_back(from + (to - from) * i / samples);
  }
  return experiment;
}

// A torque against the motion is that of a hinge which is relaxed by torque over stiffness further back.
double pulled_back(double torque, double current) {
  return bending({.rest_angle = -torque / Finger{}.stiffness}, current);
}

// Both ends of the loop: far along one way, z is 1, whatever was before.
TEST(HingeQuirks, HysteresisPullsBackWhicheverWayItGoes) {
  const double torque = 3e-4;
  const Quirks loop{.hysteresis = torque, .hysteresis_sharpness = 20.0};
  // 0.3 rad a joint is six times 1 / sharpness; the ramp's own lag is below a milliradian
  EXPECT_NEAR(bending(record({}, loop, ramp(0.0, 1.0, 8.0)).back()), pulled_back(torque, 1.0), 2e-3);
  EXPECT_NEAR(bending(record({}, loop, ramp(1.4, 0.2, 8.0)).back()), pulled_back(-torque, 0.2), 2e-3);
}

// Motional damping is a damper: at one angle kappa g^2. The finger swings so little here that g is constant.
TEST(MagneticQuirks, MotionalDampingIsADamper) {
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

TEST(ChainQuirks, DragGrowsWithTheSquareOfTheRate) {
  const State moving{.angles = {0.3, 0.3}, .rates = {8.0, 0.0}};
  constexpr double drag = 1e-5;
  Finger damped;
  damped.damping += drag * 8.0;
  const auto ours = accelerations({}, {.drag = drag}, moving, 1.0);
  const auto theirs = accelerations(damped, {}, moving, 1.0);
  for (const int j : {0, 1}) EXPECT_NEAR(ours[j], theirs[j], 1e-9 * std::abs(theirs[j]));
}

// Sticks for good, and anywhere within the band in which friction can hold it.
TEST(DryFriction, StopsTheFingerForGoodOffItsEquilibrium) {
  const Quirks quirks{.friction = 4e-4};
  const auto angles = record({}, quirks, release(1.4, 2.0));
  const auto& end = angles.back();
  EXPECT_EQ(end, angles[angles.size() - 200]);  // not a bit moves
  const State held{.angles = end, .rates = {0.0, 0.0}};
  // free of friction it would move; the torque that holds it is M times that acceleration, at most tau_c a joint
  const auto wants = accelerations({}, {}, held, 0.0);
  EXPECT_GT(std::abs(wants[0]) + std::abs(wants[1]), 1.0);
  const Finger f;
  const double m22 = f.second_mass * (f.axis_offset * f.axis_offset + f.second_com * f.second_com);
  const double m12 =
      m22 + f.second_mass * 2 * f.half_pitch * (f.second_com * std::cos(end[1]) + f.axis_offset * std::sin(end[1]));
  const double m11 = f.first_mass * (f.axis_offset * f.axis_offset + f.half_pitch * f.half_pitch) + 2 * m12 - m22 +
                     f.second_mass * 4 * f.half_pitch * f.half_pitch;
  EXPECT_LE(std::abs(m11 * wants[0] + m12 * wants[1]), quirks.friction);
  EXPECT_LE(std::abs(m12 * wants[0] + m22 * wants[1]), quirks.friction);
}

// Where the finger creeps in one direction, Coulomb friction is a torque and no more.
TEST(DryFriction, IsAConstantTorqueInOneDirection) {
  const double torque = 2e-4;
  // the ramp's own lag and what rings on it: 2 mrad, a seventh of what friction does
  EXPECT_NEAR(bending(record({}, {.friction = torque}, ramp(0.2, 0.8, 4.0)).back()), pulled_back(torque, 0.8), 2e-3);
  EXPECT_NEAR(bending(record({}, {.friction = torque}, ramp(1.2, 0.4, 4.0)).back()), pulled_back(-torque, 0.4), 2e-3);
  EXPECT_GT(bending(Quirks{}, 0.8) - pulled_back(torque, 0.8), 0.01);
}

// How far a joint goes into its stop: what both joints' motion could bring there, 1/2 k p^2, is less than the work of
// the coils up to it.
TEST(EndStop, HoldsEitherSide) {
  const double stiffness = 0.6;
  Experiment step = constant(1.4, 2.0);
  step.currents[0] = 0.0;
  const double at_most = std::sqrt(2.0 * 2 * 1.4 * 0.0175 * 0.45 / stiffness);
  const auto highest = [&](const Quirks& quirks) {
    double angle = 0.0;
    for (const auto& angles : record({}, quirks, step)) angle = std::max({angle, angles[0], angles[1]});
    return angle;
  };
  const double stopped = highest({.stop_angle = 0.45, .stop_stiffness = stiffness, .stop_side = 1.0});
  EXPECT_GT(stopped, 0.45);
  EXPECT_LT(stopped, 0.45 + at_most);
  EXPECT_LT(stopped, highest({}) - 10.0 * degree);
  const auto lowest = [&](const Quirks& quirks) {
    double angle = 1.0;
    for (const auto& angles : record({}, quirks, release(1.4, 1.0))) angle = std::min({angle, angles[0], angles[1]});
    return angle;
  };
  const double caught = lowest({.stop_angle = 0.1, .stop_stiffness = stiffness, .stop_side = -1.0});
  EXPECT_LT(caught, 0.1);
  EXPECT_GT(caught, lowest({}) + 2.0 * degree);
}

TEST(CameraQuirks, ShowTheMotionLate) {
  const Experiment experiment = release(1.4, 0.5);
  const auto late = record({}, {.delay = 0.006}, experiment);
  const auto now = record({}, {}, experiment);
  for (std::size_t i = 3; i < now.size(); ++i)
    for (const int j : {0, 1}) EXPECT_NEAR(late[i][j], now[i - 3][j], same_motion);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(late[i], now[0]);
}

TEST(HiddenKinds, HoldEveryIdOfTheFormatAndSixOutsiders) {
  int ids = 0;
  int outsiders = 0;
  for (const HiddenKind& kind : hidden_kinds()) ++(kind.outsider ? outsiders : ids);
  for (const char* id :
       {"dry_friction",      "quadratic_drag",    "viscoelastic_creep", "hysteresis",     "stiffness_hardening",
        "joint_asymmetry",   "rest_angle",        "end_stop",           "base_tilt",      "added_mass",
        "force_gain",        "coil_lag",          "back_emf",           "coil_heating",   "magnet_heating",
        "driver_saturation", "driver_deadband",   "current_offset",     "off_axis_force", "coil_coil_force",
        "static_attraction", "measurement_delay", "angle_offset",       "angle_scale"}) {
    EXPECT_FALSE(hidden_kind(id).outsider) << id;
    --ids;
  }
  EXPECT_EQ(ids, 0);
  EXPECT_GE(outsiders, 6);
  EXPECT_THROW((void)hidden_kind("gremlins"), std::invalid_argument);
}

// Halving the integrator's room to move (twice as many samples, inputs alike) changes nothing: every quirk, at half of
// its bound, through the paper's 2 Hz sine.
TEST(Motion, DoesNotDependOnHowItIsSampled) {
  const Bench bench = paper_bench();
  const Experiment& sine = bench.fit[6];
  Experiment twice;
  for (std::size_t i = 0; i < sine.times.size(); ++i)
    for (const double later : {0.0, 0.001}) {
      twice.times.push_back(sine.times[i] + later);
      twice.currents.push_back(sine.currents[i]);
    }
  for (const HiddenKind& kind : hidden_kinds()) {
    if (kind.outsider) continue;  // chance is drawn a sample
    Random random(11);
    Quirks quirks;
    kind.draw(random, {.lowest = -0.1, .highest = 0.9}, quirks)(quirks, 0.1);
    const auto once = record({}, quirks, sine);
    auto other = record({}, quirks, twice);
    Record every_second;
    for (std::size_t i = 0; i < other.size(); i += 2) every_second.push_back(other[i]);
    EXPECT_LT(largest_gap(once, every_second), same_motion) << kind.id;
  }
}

}  // namespace
}  // namespace truth
