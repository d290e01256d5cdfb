#include "coilwright/measurement/localise/residual_torque.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "coilwright/simulation/transient.hpp"
#include "degree.hpp"
#include "error_text.hpp"
#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::localise {
namespace {

using mechanics::JointVector;
using std::numbers::pi;
using testing::HasSubstr;

constexpr double interval = 0.002;
constexpr double gravity = 9.81;

// A rig of one or two joints that the test integrates by itself, with the equations written out.
struct Rig {
  int joints{};
  double length = 0.02, com = 0.01;             // of both links, m
  std::array<double, 2> mass{0.020, 0.015};     // kg
  double inertia = 4e-6;                        // of both, about the centre of mass, kg m^2
  double stiffness = 0.0125, damping = 1.3e-4;  // of both joints
};

using Vector = std::array<double, 2>;
struct Moment {
  double time{};
  Vector angle{}, rate{};
  double current{};
};
/// Torque that the model does not know, per joint, N m.
using Hidden = std::function<Vector(const Moment&)>;
/// Command at a time: applied torque (the same in all joints), N m, and current, A.
struct Command {
  std::function<double(double)> torque;
  std::function<double(double)> current;
};

// Lagrange's equations of a double pendulum of relative angles, solved by Cramer's rule.
Vector acceleration(const Rig& rig, const Vector& q, const Vector& w, const Vector& torque) {
  const double m1 = rig.mass[0], m2 = rig.joints == 2 ? rig.mass[1] : 0.0;
  const double i1 = rig.inertia, i2 = rig.joints == 2 ? rig.inertia : 1.0;
  const double l = rig.length, r = rig.com;
  const double c = std::cos(q[1]), s = std::sin(q[1]);
  const double m22 = i2 + m2 * r * r;
  const double m12 = m22 + m2 * l * r * c;
  const double m11 = i1 + m1 * r * r + m22 + m2 * (l * l + 2.0 * l * r * c);
  const double coupling = m2 * l * r * s;
  const double g2 = m2 * gravity * r * std::sin(q[0] + q[1]);
  const double g1 = (m1 * r + m2 * l) * gravity * std::sin(q[0]) + g2;
  const double f1 =
      torque[0] - rig.stiffness * q[0] - rig.damping * w[0] - g1 + coupling * (2.0 * w[0] * w[1] + w[1] * w[1]);
  if (rig.joints == 1) return {f1 / (i1 + m1 * r * r), 0.0};
  const double f2 = torque[1] - rig.stiffness * q[1] - rig.damping * w[1] - g2 - coupling * w[0] * w[0];
  const double determinant = m11 * m22 - m12 * m12;
  return {(m22 * f1 - m12 * f2) / determinant, (m11 * f2 - m12 * f1) / determinant};
}

actuator::Model model_of(const Rig& rig) {
  std::vector<mechanics::Link> links;
  for (int j = 0; j < rig.joints; ++j)
    links.push_back(
        {.length = rig.length, .com_along = rig.com, .com_offset = 0.0, .mass = rig.mass[j], .inertia = rig.inertia});
  return actuator::Model(
      {.chain = mechanics::PlanarChain(links, gravity),
       .hinges = std::vector<actuator::Hinge>(rig.joints, {.stiffness = rig.stiffness, .damping = rig.damping}),
       .magnetics = {},
       .coils = 1,
       .tip = {}});
}

// Classical Runge-Kutta, ten steps per sample, input held over the sample, from rest.
MeasuredMotion measured(const Rig& rig, const actuator::Model& model, const Command& command, const Hidden& hidden,
                        bool bending, std::uint64_t seed, double duration = 6.0, double sigma = 0.3 * degree) {
  Normal normal(seed);
  MeasuredMotion motion;
  motion.run = "run" + std::to_string(seed) + ".csv";
  motion.model = &model;
  motion.angles.resize(bending ? 1 : rig.joints);
  motion.sigma.assign(motion.angles.size(), sigma);
  Vector q{}, w{};
  constexpr int substeps = 10;
  constexpr double h = interval / substeps;
  for (int sample = 0; sample * interval < duration; ++sample) {
    const double start = sample * interval;
    const double torque = command.torque(start);
    const double current = command.current(start);
    motion.input.times.push_back(start);
    motion.input.currents.push_back(actuator::CoilCurrents::Constant(1, current));
    motion.input.joint_torques.push_back(JointVector::Constant(rig.joints, torque));
    if (bending) {
      motion.angles[0].push_back(q[0] + q[1] + sigma * normal());
    } else {
      for (int j = 0; j < rig.joints; ++j) motion.angles[j].push_back(q[j] + sigma * normal());
    }
    for (int step = 0; step < substeps; ++step) {
      const auto slope = [&](double dt, const Vector& a, const Vector& b) {
        const Vector extra = hidden({start + step * h + dt, a, b, current});
        return acceleration(rig, a, b, {torque + extra[0], torque + extra[1]});
      };
      const auto moved = [](const Vector& v, const Vector& by, double dt) {
        return Vector{v[0] + dt * by[0], v[1] + dt * by[1]};
      };
      const Vector a1 = slope(0.0, q, w);
      const Vector w2 = moved(w, a1, h / 2), a2 = slope(h / 2, moved(q, w, h / 2), w2);
      const Vector w3 = moved(w, a2, h / 2), a3 = slope(h / 2, moved(q, w2, h / 2), w3);
      const Vector w4 = moved(w, a3, h), a4 = slope(h, moved(q, w3, h), w4);
      for (int j = 0; j < 2; ++j) {
        q[j] += h / 6.0 * (w[j] + 2.0 * w2[j] + 2.0 * w3[j] + w4[j]);
        w[j] += h / 6.0 * (a1[j] + 2.0 * a2[j] + 2.0 * a3[j] + a4[j]);
      }
    }
  }
  motion.simulated = simulation::simulate(
      model, motion.input, {.angles = JointVector::Zero(rig.joints), .rates = JointVector::Zero(rig.joints)});
  return motion;
}

Command sine(double amplitude, double frequency, double current = 0.0) {
  return {[=](double t) { return amplitude * std::sin(2.0 * pi * frequency * t); },
          [=](double t) { return current * std::sin(2.0 * pi * 0.31 * frequency * t); }};
}

// Four motions: three sines and one of two steps.
std::vector<MeasuredMotion> motions(const Rig& rig, const actuator::Model& model, const Hidden& hidden, bool bending,
                                    std::uint64_t seed = 1) {
  const double size = rig.joints == 1 ? 0.010 : 0.007;
  const Command steps{[=](double t) { return t < 1.0   ? 0.0
                                             : t < 3.5 ? size
                                                       : 0.4 * size; },
                      [](double t) { return t < 2.0 ? 0.0 : 1.0; }};
  return {measured(rig, model, sine(size, 0.5, 1.0), hidden, bending, seed),
          measured(rig, model, sine(0.8 * size, 1.1, 0.6), hidden, bending, seed + 1),
          measured(rig, model, sine(0.5 * size, 2.3, 1.4), hidden, bending, seed + 2),
          measured(rig, model, steps, hidden, bending, seed + 3)};
}

const Dependence* find(const ResidualTorque& found, const std::string& variable) {
  for (const Dependence& dependence : found.dependences)
    if (dependence.variable == variable) return &dependence;
  return nullptr;
}

ResidualTorque found_in(int joints, bool bending, const Hidden& hidden) {
  const Rig rig{.joints = joints};
  const actuator::Model model = model_of(rig);
  const ResidualTorque found = residual_torque(motions(rig, model, hidden, bending));
  return found;
}

const Hidden nothing = [](const Moment&) { return Vector{}; };
// The same in both joints.
Hidden equally(const std::function<double(const Moment&)>& torque) {
  return [=](const Moment& moment) {
    const double t = torque(moment);
    return Vector{t, t};
  };
}

TEST(ResidualTorque, OfACompleteModelIsNoise) {
  for (const bool bending : {true, false}) {
    const ResidualTorque found = found_in(2, bending, nothing);
    EXPECT_GT(found.noise_floor, 0.0);
    EXPECT_LT(found.rms, 1.5 * found.noise_floor);
    EXPECT_FALSE(found.frequency);
    for (const Dependence& dependence : found.dependences) EXPECT_LT(dependence.explained, 0.1) << dependence.variable;
  }
}

TEST(ResidualTorque, OfCoulombFrictionFollowsTheSignOfTheRate) {
  const ResidualTorque found =
      found_in(1, true, equally([](const Moment& m) { return -8e-4 * std::tanh(m.rate[0] / 0.02); }));
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "sign of rate");
  EXPECT_GT(found.dependences.front().explained, 0.6);
  const Dependence& sign = found.dependences.front();
  ASSERT_EQ(sign.at.size(), 3u);
  // The smoother rounds the jumps, so the means fall short of 0.8 mN m.
  EXPECT_NEAR(sign.residual[0], 8e-4, 1.5e-4);
  EXPECT_NEAR(sign.residual[2], -8e-4, 1.5e-4);
}

TEST(ResidualTorque, OfAHardeningSpringFollowsTheAngle) {
  const ResidualTorque found =
      found_in(1, true, equally([](const Moment& m) { return -4e-3 * std::pow(m.angle[0], 3); }));
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "angle");
  EXPECT_GT(found.dependences.front().explained, 0.8);
  const Dependence& angle = found.dependences.front();
  for (std::size_t b = 1; b + 1 < angle.at.size(); ++b)
    EXPECT_NEAR(angle.residual[b], -4e-3 * std::pow(angle.at[b], 3), 1.2e-4) << angle.at[b];
}

TEST(ResidualTorque, OfDragFollowsTheRate) {
  const ResidualTorque found =
      found_in(1, true, equally([](const Moment& m) { return -3e-5 * m.rate[0] * std::abs(m.rate[0]); }));
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "rate");
  EXPECT_GT(found.dependences.front().explained, 0.6);
}

TEST(ResidualTorque, OfACurrentFollowsTheCurrent) {
  const ResidualTorque found = found_in(1, true, equally([](const Moment& m) { return 6e-4 * m.current * m.current; }));
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "current");
  EXPECT_GT(found.dependences.front().explained, 0.7);
  const Dependence& current = found.dependences.front();
  for (std::size_t b = 0; b < current.at.size(); ++b)
    EXPECT_NEAR(current.residual[b], 6e-4 * current.at[b] * current.at[b], 1.5e-4) << current.at[b];
}

TEST(ResidualTorque, OfADriftFollowsTheTime) {
  const ResidualTorque found = found_in(1, true, equally([](const Moment& m) { return 2.5e-4 * m.time; }));
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "time");
  EXPECT_GT(found.dependences.front().explained, 0.8);
  const Dependence& time = found.dependences.front();
  for (std::size_t b = 0; b < time.at.size(); ++b) EXPECT_NEAR(time.residual[b], 2.5e-4 * time.at[b], 1e-4);
}

TEST(ResidualTorque, OfAShakenBaseIsASpectralLine) {
  const ResidualTorque found =
      found_in(1, true, equally([](const Moment& m) { return 5e-4 * std::sin(2.0 * pi * 7.0 * m.time + 0.5); }));
  ASSERT_TRUE(found.frequency);
  EXPECT_NEAR(*found.frequency, 7.0, 0.1);
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "frequency");
  EXPECT_GT(found.dependences.front().explained, 0.5);
  EXPECT_NEAR(found.dependences.front().residual.front(), 5e-4, 1.5e-4);
}

TEST(ResidualTorque, OfABendingAngleIsSharedAmongTheJoints) {
  // The friction of each joint is its own, but all the camera sees is the sum of the angles.
  const ResidualTorque found = found_in(2, true, [](const Moment& m) {
    return Vector{-4e-4 * std::tanh(m.rate[0] / 0.02), -4e-4 * std::tanh(m.rate[1] / 0.02)};
  });
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "sign of rate");
  EXPECT_NEAR(found.dependences.front().residual.front(), 4e-4, 1.2e-4);
}

TEST(ResidualTorque, NamesTheJointIfEachIsMeasured) {
  const ResidualTorque found = found_in(2, false, [](const Moment& m) {
    return Vector{0.0, -6e-4 * std::tanh(m.rate[1] / 0.02)};
  });
  ASSERT_FALSE(found.dependences.empty());
  EXPECT_EQ(found.dependences.front().variable, "sign of rate of joint 2");
  EXPECT_NEAR(found.dependences.front().residual.front(), 6e-4, 2e-4);
  const Dependence* other = find(found, "sign of rate of joint 1");
  EXPECT_LT(other == nullptr ? 0.0 : other->explained, 0.5 * found.dependences.front().explained);
}

TEST(ResidualTorque, LeavesOutTheEdgesOfWindows) {
  // The model starts anew every second from the measured motion's own true state: no jump may leak into the torque.
  const Rig rig{.joints = 1};
  const actuator::Model model = model_of(rig);
  std::vector<MeasuredMotion> whole = motions(rig, model, nothing, true);
  for (MeasuredMotion& motion : whole) {
    motion.starts.clear();
    double offset = 0.3;
    for (std::size_t first = 0; first < motion.input.times.size(); first += 500) {
      motion.starts.push_back(first);
      offset = -offset;
      for (std::size_t i = first; i < std::min(first + 500, motion.input.times.size()); ++i)
        motion.angles[0][i] += 1e-2 * offset;
    }
  }
  const ResidualTorque found = residual_torque(whole);
  // Jumps of 6 mrad, as large as the noise, move the static torque by 0.0125 * 3 mrad = 38 uN m and no more.
  EXPECT_LT(found.rms, 1.5 * found.noise_floor + 8e-5);
}

// A weight that hangs at the last link in some runs, as data::RigChange says.
TEST(ResidualTorque, TakesEachMotionOnItsOwnRig) {
  const Rig rig{.joints = 2};
  Rig heavier = rig;
  heavier.mass[1] += 0.01;
  const actuator::Model model = model_of(rig), changed = model_of(heavier);
  std::vector<MeasuredMotion> all = motions(rig, model, nothing, true);
  for (MeasuredMotion& motion : motions(heavier, changed, nothing, true, 11)) all.push_back(std::move(motion));
  const ResidualTorque found = residual_torque(all);
  EXPECT_LT(found.rms, 1.5 * found.noise_floor);
  const simulation::State rest{.angles = JointVector::Zero(2), .rates = JointVector::Zero(2)};
  for (MeasuredMotion& motion : all) {
    motion.model = &model;
    motion.simulated = simulation::simulate(model, motion.input, rest);
  }
  EXPECT_GT(residual_torque(all).rms, 5.0 * found.noise_floor);
}

TEST(ResidualTorque, WithoutMotionIsZero) {
  const Rig rig{.joints = 1};
  const actuator::Model model = model_of(rig);
  EXPECT_EQ(residual_torque({}).rms, 0.0);
  const std::vector<MeasuredMotion> brief{measured(rig, model, sine(0.01, 1.0), nothing, true, 1, 0.02)};
  EXPECT_EQ(residual_torque(brief).rms, 0.0);
}

TEST(ResidualTorque, RefusesSizesThatDoNotMatch) {
  const Rig rig{.joints = 1};
  const actuator::Model model = model_of(rig);
  const MeasuredMotion good = measured(rig, model, sine(0.01, 1.0), nothing, true, 1, 0.2);
  const auto text = [&](const std::function<void(MeasuredMotion&)>& change) {
    MeasuredMotion motion = good;
    change(motion);
    return error_text([&] { (void)residual_torque(std::vector{motion}); });
  };
  EXPECT_EQ(text([](MeasuredMotion&) {}), "");
  EXPECT_EQ(text([](MeasuredMotion& m) { m.model = nullptr; }), "run1.csv: needs a model");
  EXPECT_EQ(text([](MeasuredMotion& m) { m.simulated.pop_back(); }),
            "run1.csv: one simulated state for each sample; got 99");
  EXPECT_EQ(text([](MeasuredMotion& m) { m.angles.clear(); }),
            "run1.csv: measured angles must be of every joint, or their sum; got 0");
  EXPECT_EQ(text([](MeasuredMotion& m) { m.angles[0].pop_back(); }),
            "run1.csv: one measured angle for each sample; got 99");
  EXPECT_EQ(text([](MeasuredMotion& m) { m.sigma = {0.0}; }), "run1.csv: sigma must be > 0; got 0");
  EXPECT_EQ(text([](MeasuredMotion& m) {
              m.starts = {0, 100};
            }),
            "run1.csv: starts of windows must rise and stay inside the run; got 100");
  EXPECT_THAT(text([](MeasuredMotion& m) { m.input.times[5] = 0.0; }), HasSubstr("run1.csv: "));
}

}  // namespace
}  // namespace coilwright::measurement::localise
