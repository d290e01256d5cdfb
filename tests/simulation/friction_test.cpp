#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/transient.hpp"
#include "simulation/held_joints.hpp"

namespace coilwright::simulation {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using actuator::ModelSpec;
using mechanics::JointVector;

constexpr double inertia = 6.7e-6;
constexpr double friction = 0.6e-3;

// One joint with a body that gravity does not move, on a spring, with a load against it, N m.
struct Rotor {
  double stiffness = 0.0;
  double load = 0.0;
};

Model model_of(const Rotor& rotor, const char* id, std::vector<double> values, bool further = false) {
  const mechanics::Link link{.length = 0.1, .com_along = 0.0, .com_offset = 0.0, .mass = 1.0, .inertia = inertia};
  ModelSpec spec{.chain = mechanics::PlanarChain({&link, 1}, 0.0),
                 .hinges = {{.stiffness = rotor.stiffness, .torque_offset = -rotor.load}},
                 .magnetics = {},
                 .coils = 0,
                 .tip = {}};
  const actuator::EffectKind* kind = actuator::standard_effects().find(id);
  spec.effects = {{.kind = further ? kind->with_further_numbers() : kind, .values = std::move(values)}};
  return Model(spec);
}

// Under torques that are held from each time to the next; `accuracy` a step.
std::vector<State> moved(const Model& model, double angle, std::vector<double> times,
                         const std::vector<double>& torques, double accuracy = 1e-8) {
  ModelInput input{.times = std::move(times)};
  for (const double torque : torques) {
    input.currents.emplace_back(0);
    input.joint_torques.push_back(JointVector::Constant(1, torque));
  }
  const State start{.angles = JointVector::Constant(1, angle), .rates = JointVector::Zero(1)};
  return simulate(model, input, start, {.relative = accuracy});
}

State after(const Model& model, double angle, double torque, double time) {
  return moved(model, angle, {0.0, time}, {torque, torque}).back();
}

TEST(Friction, HoldsAgainstASmallerTorqueForEver) {
  const Model model = model_of({}, "dry_friction", {friction});
  for (const double share : {0.6, -0.999, 0.0}) {
    const State state = after(model, 0.3, share * friction, 100.0);
    EXPECT_EQ(state.angles[0], 0.3);
    EXPECT_EQ(state.rates[0], 0.0);
    EXPECT_NEAR(state.internal[0], share, 1e-9) << "what holds it";
  }
}

TEST(Friction, LetsALargerTorqueThroughLessItself) {
  const Model model = model_of({}, "dry_friction", {friction});
  for (const double share : {1.5, -1.001}) {
    const State state = after(model, 0.0, share * friction, 0.1);
    const double rate = std::copysign(std::abs(share) - 1.0, share) * friction / inertia * 0.1;
    EXPECT_NEAR(state.rates[0], rate, 1e-7 * std::abs(rate));
    EXPECT_EQ(state.internal[0], std::copysign(1.0, share));
  }
}

// Coulomb's envelope is a straight line, each half swing 2 tau_c / k shorter, and it stands where the spring pulls less
// than tau_c: half swings of cosines about -+ tau_c / k.
TEST(Friction, LetsAFreeSwingDecayLinearlyAndStandBesideTheMiddle) {
  constexpr double stiffness = 12.5e-3;
  constexpr double held = 0.1 * friction / stiffness;
  const Model model = model_of({.stiffness = stiffness}, "dry_friction", {0.1 * friction});
  const double half = std::numbers::pi * std::sqrt(inertia / stiffness);
  constexpr double start = 8.4 * held;  // turns at -6.4, 4.4, -2.4 and stands at 0.4 of it
  std::vector<double> times;
  for (int i = 0; i <= 500; ++i) times.push_back(0.01 * half * i);
  const std::vector<State> states = moved(model, start, times, std::vector<double>(times.size(), 0.0));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const int swing = static_cast<int>(i / 100);
    const double away = 8.4 - 2.0 * swing;
    const double side = swing % 2 == 0 ? 1.0 : -1.0;
    const double angle =
        swing >= 4
            ? 0.4 * held
            : side * held * (1.0 + (away - 1.0) * std::cos(std::numbers::pi * (0.01 * static_cast<double>(i) - swing)));
    EXPECT_NEAR(states[i].angles[0], angle, 1e-6 * start) << i;
  }
  EXPECT_EQ(states.back().rates[0], 0.0);
  EXPECT_NEAR(states.back().internal[0], -0.4, 1e-5);
}

// A torque that rises and falls again, in a straight line each: J w' = 2 tau_c (t - 1/2) from 1/2 s and 2 tau_c (3/2 -
// t) from 1 s on, so that it stops at 3/2 + sqrt(1/2) s.
TEST(Friction, SlipsAndStopsInsideARampOfTheInput) {
  const Model model = model_of({}, "dry_friction", {friction});
  ModelInput input{.times = {0.0, 1.0, 3.0}, .currents = std::vector<CoilCurrents>(3, CoilCurrents(0))};
  for (const double share : {0.0, 2.0, -2.0}) input.joint_torques.push_back(JointVector::Constant(1, share * friction));
  input.straight = {1, 1, 0};
  const State start{.angles = JointVector::Zero(1), .rates = JointVector::Zero(1)};
  const double stops = 1.5 + std::sqrt(0.5);
  const std::vector<State> states = simulate_at(
      model, input, start, std::vector{0.499, 0.501, 1.0, 1.5, stops - 1e-3, stops + 1e-3}, {.relative = 1e-9});
  const double unit = friction / inertia;
  EXPECT_EQ(states[0].rates[0], 0.0);
  EXPECT_NEAR(states[0].internal[0], 0.998, 1e-9);
  EXPECT_NEAR(states[1].rates[0], 1e-6 * unit, 1e-9 * unit);
  EXPECT_NEAR(states[2].rates[0], 0.25 * unit, 1e-8 * unit);
  EXPECT_NEAR(states[3].rates[0], 0.5 * unit, 1e-8 * unit);
  EXPECT_GT(states[4].rates[0], 1e-4 * unit);
  EXPECT_EQ(states[5].rates[0], 0.0);
}

TEST(StribecksFriction, HoldsItsStaticTorqueAndNoMore) {
  constexpr double ratio = 1.45;
  const Model model = model_of({}, "dry_friction", {friction, ratio, 0.8}, true);
  EXPECT_EQ(after(model, 0.0, (ratio - 1e-6) * friction, 10.0).angles[0], 0.0);
  EXPECT_GT(after(model, 0.0, (ratio + 1e-3) * friction, 1.0).angles[0], 1.0);
}

// A motor holds what lies between 1 - mu and 1 + mu of its torque, and moves what does not with the rest.
TEST(LoadFriction, HoldsALoadNearTheDrivesTorqueAndMovesAnyOther) {
  constexpr double share = 0.2;
  constexpr double drive = 1e-3;
  const auto state_after = [&](double load) {
    return after(model_of({.load = load * drive}, "load_friction", {share}), 0.0, drive, 0.5);
  };
  for (const double held : {0.81, 0.9, 1.1, 1.19}) EXPECT_EQ(state_after(held).rates[0], 0.0) << held;
  for (const double load : {0.7, 1.3}) {
    const double left = (1.0 - load + (load < 1.0 ? -share : share)) * drive;
    EXPECT_NEAR(state_after(load).rates[0], left / inertia * 0.5, 1e-7 * std::abs(left) / inertia) << load;
  }
}

// Without a drive there is no friction, and what pulls moves it from the first instant.
TEST(LoadFriction, HoldsNothingWithoutADrive) {
  const Model model = model_of({.load = 1e-6}, "load_friction", {0.2});
  EXPECT_NEAR(after(model, 0.0, 0.0, 0.5).rates[0], -1e-6 / inertia * 0.5, 1e-9);
  EXPECT_EQ(after(model_of({}, "load_friction", {0.2}), 0.0, 0.0, 0.5).rates[0], 0.0);
}

// While a joint is held nothing keeps steps short, and a torque along a curve lets it slip in the middle of a long one:
// T sin(w t) slides it from where that is F until the rate (T / w (cos w t1 - cos w t) - F (t - t1)) / J is zero again,
// one way in the first half of each period and back in the second.
TEST(Friction, LetsAJointSlipForAMomentOfAnInputAlongACurve) {
  constexpr double torque = 1.2 * friction;
  constexpr double w = 4.0 * std::numbers::pi;  // 2 Hz
  const double slips = std::asin(friction / torque) / w;
  const auto rate = [&](double time) {
    return (torque / w * (std::cos(w * slips) - std::cos(w * time)) - friction * (time - slips)) / inertia;
  };
  double stops = std::numbers::pi / w;
  for (double before = 0.5 * stops, step = 0.25 * stops; step > 1e-15; step *= 0.5) {
    if (rate(before + step) > 0.0) before += step;
    stops = before;
  }
  const double sliding = stops - slips;
  const double moves = (torque / w * (sliding * std::cos(w * slips) - (std::sin(w * stops) - std::sin(w * slips)) / w) -
                        0.5 * friction * sliding * sliding) /
                       inertia;
  ASSERT_GT(moves, 0.01);

  ModelInput input;
  for (int i = 0; i <= 1000; ++i) {
    input.times.push_back(2e-3 * i);
    input.currents.emplace_back(0);
    input.joint_torques.push_back(JointVector::Constant(1, torque * std::sin(w * input.times.back())));
  }
  input.straight.assign(input.times.size(), 1);
  input.straight.back() = 0;
  input.passed = input.straight;
  input.passed.front() = 0;
  const std::vector<State> motion =
      simulate(model_of({}, "dry_friction", {friction}), input,
               {.angles = JointVector::Zero(1), .rates = JointVector::Zero(1)}, {.relative = 1e-9});
  for (int half = 0; half < 8; ++half) {
    const State& end = motion[static_cast<std::size_t>(125 * (half + 1))];
    EXPECT_NEAR(end.angles[0], half % 2 == 0 ? moves : 0.0, 1e-5 * moves) << half;
    EXPECT_EQ(end.rates[0], 0.0);
  }
}

// A torque as rough as a measured one, along a curve: 1 s of 1000 samples.
ModelInput rough(double size) {
  ModelInput out;
  std::mt19937_64 random(20261130);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i <= 1000; ++i) {
    out.times.push_back(1e-3 * i);
    out.currents.emplace_back(0);
    out.joint_torques.push_back(JointVector::Constant(1, size * (std::sin(0.02 * i) + 0.3 * any(random))));
  }
  out.straight.assign(out.times.size(), 1);
  out.straight.back() = 0;
  out.passed = out.straight;
  out.passed.front() = 0;
  return out;
}

// The steps of a motion give that motion again, but for the rounding of their ends.
TEST(GivenSteps, RepeatAMotion) {
  const Model model = model_of({.stiffness = 5e-3}, "dry_friction", {friction});
  const ModelInput input = rough(3.0 * friction);
  const State start{.angles = JointVector::Constant(1, 0.1), .rates = JointVector::Constant(1, -2.0)};
  TransientSteps steps;
  const std::vector<State> motion = simulate(model, input, start, {.relative = 1e-6, .taken = &steps});
  const std::vector<State> again = simulate(model, input, start, {.relative = 1e-6, .steps = &steps});
  for (std::size_t i = 0; i < motion.size(); ++i) {
    EXPECT_NEAR(motion[i].angles[0], again[i].angles[0], 1e-13) << i;
    EXPECT_NEAR(motion[i].rates[0], again[i].rates[0], 1e-11) << i;
  }
}

// x(t) of a damped rotor moves by (1 - exp(-b t / J)) J / b with its first rate, whatever drives it: with the same
// steps the difference of two motions is that to a thousandth, where the errors of their own are as large as it is.
TEST(GivenSteps, LeaveOnlyWhatSetsTwoMotionsApart) {
  constexpr double change = 1e-5;
  constexpr double damping = 2e-5;
  const mechanics::Link link{.length = 0.1, .com_along = 0.0, .com_offset = 0.0, .mass = 1.0, .inertia = inertia};
  const Model model({.chain = mechanics::PlanarChain({&link, 1}, 0.0),
                     .hinges = {{.damping = damping}},
                     .magnetics = {},
                     .coils = 0,
                     .tip = {}});
  const ModelInput input = rough(3.0 * friction);
  TransientSteps steps;
  const auto motion = [&](double rate, const Accuracy& accuracy) {
    return simulate(model, input, {.angles = JointVector::Zero(1), .rates = JointVector::Constant(1, rate)}, accuracy);
  };
  const std::vector<State> base = motion(0.3, {.relative = 1e-6, .taken = &steps});
  const std::vector<State> moved = motion(0.3 + change, {.relative = 1e-6, .steps = &steps});
  for (std::size_t i = 0; i < base.size(); ++i) {
    const double expected = (1.0 - std::exp(-damping / inertia * input.times[i])) * inertia / damping;
    EXPECT_NEAR((moved[i].angles[0] - base[i].angles[0]) / change, expected, 1e-3 * inertia / damping) << i;
  }
}

// Of four links in random poses under random torques: held joints stay at rest by no more than their friction, those
// that are let go set out the way that friction opposes.
void expect_held_by_friction(std::vector<actuator::Effect> effects) {
  constexpr int joints = 4;
  std::vector<mechanics::Link> links;
  for (int j = 0; j < joints; ++j)
    links.push_back(
        {.length = 0.2, .com_along = 0.1 + 0.02 * j, .com_offset = 0.0, .mass = 0.4 + 0.1 * j, .inertia = 1e-4});
  const Model model({.chain = mechanics::PlanarChain(links),
                     .hinges = std::vector<actuator::Hinge>(joints),
                     .magnetics = {},
                     .coils = 0,
                     .tip = {},
                     .effects = std::move(effects)});
  const auto states = static_cast<std::size_t>(model.internal_states());
  std::mt19937_64 random(20261129);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int held = 0;
  int let_go = 0;
  for (int trial = 0; trial < 500; ++trial) {
    PackedState values(2 * joints + states, 0.0);
    for (std::size_t i = 3 * joints; i < values.size(); ++i) values[i] = 1e-3 * any(random);
    JointVector torques(joints);
    for (int j = 0; j < joints; ++j) {
      values[j] = any(random);
      values[joints + j] = trial % 3 == 0 && j == trial % joints ? any(random) : 0.0;
      torques[j] = 2.0 * any(random);
    }
    const auto slopes_of = [&](const PackedState& at, PackedState& slopes, std::span<const int> still) {
      const JointVector angles = Eigen::Map<const Eigen::VectorXd>(at.data(), joints);
      const JointVector rates = Eigen::Map<const Eigen::VectorXd>(at.data() + joints, joints);
      JointVector accelerations;
      model.derivative(angles, rates, {at.data() + 2 * joints, states}, CoilCurrents(0), torques, accelerations,
                       {slopes.data() + 2 * joints, states}, still);
      std::copy_n(rates.data(), joints, slopes.data());
      std::copy_n(accelerations.data(), joints, slopes.data() + joints);
    };
    const auto derive = [&](const PackedState& at, PackedState& slopes) { slopes_of(at, slopes, {}); };
    HeldJoints of(model);
    of.decide(values, -1, derive);
    of.set(of.signs(), values);
    PackedState slopes(values.size(), 0.0);
    slopes_of(values, slopes, of.held());
    const JointVector shares = of.shares(values, derive);
    // What holds them, as any other torque: the same motion, of the joints and of what moves beside them.
    PackedState freely(values.size(), 0.0);
    of.set(shares, values);
    derive(values, freely);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(freely[i], slopes[i], 1e-8 * (100.0 + std::abs(slopes[i]))) << trial << ' ' << i;
    for (int j = 0; j < joints; ++j) {
      if (of.holds(j)) {
        EXPECT_EQ(slopes[joints + j], 0.0);
        EXPECT_LE(std::abs(shares[j]), 1.0 + 1e-9);
        ++held;
      } else if (values[joints + j] == 0.0) {
        EXPECT_GE(slopes[joints + j] * shares[j], 0.0) << trial << ' ' << j;
        EXPECT_EQ(std::abs(shares[j]), 1.0);
        ++let_go;
      } else {
        EXPECT_EQ(shares[j], values[joints + j] > 0.0 ? 1.0 : -1.0);
      }
    }
  }
  EXPECT_GT(held, 200);
  EXPECT_GT(let_go, 200);
}

actuator::Effect effect(const char* id, std::vector<double> values) {
  return {.kind = actuator::standard_effects().find(id), .values = std::move(values)};
}

TEST(HeldJoints, AreThoseThatFrictionCanHold) {
  expect_held_by_friction({effect("dry_friction", {0.7})});
}

TEST(HeldJoints, AreThoseThatFrictionCanHoldOnAMountThatGivesWay) {
  expect_held_by_friction({effect("dry_friction", {0.7}), effect("mount_compliance", {60.0, 2.0})});
}

}  // namespace
}  // namespace coilwright::simulation
