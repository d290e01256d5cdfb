#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "actuator/sample_effects.hpp"
#include "coilwright/simulation/transient.hpp"
#include "error_text.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Effect;
namespace sample = actuator::sample;

State at_rest(const Model& model) {
  return {.angles = straight(model), .rates = straight(model)};
}

State at_rest_with(const Model& model, double internal) {
  State start = at_rest(model);
  start.internal = Eigen::VectorXd::Constant(model.internal_states(), internal);
  return start;
}

// J theta'' = i, i' = (I - i) / T from rest: twice the integral of I (1 - exp(-t / T)).
TEST(SimulateEffects, FollowsALagInClosedForm) {
  const double time = 0.05;
  const Model model = sample::rig({.inertia = 2.0}, {{&sample::lag, {time}}});
  ASSERT_EQ(model.internal_states(), 1);
  ASSERT_EQ(model.drive_states(), 1);
  const ModelInput input = step_input(model, {.current = 0.3, .duration = 2.0, .interval = 0.01});
  const std::vector<State> motion = simulate(model, input, at_rest_with(model, 0.0), {.relative = 1e-10});
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double t = input.times[i];
    const double gone = std::exp(-t / time);
    EXPECT_NEAR(motion[i].internal[0], 0.3 * (1.0 - gone), 2e-9);
    EXPECT_NEAR(motion[i].rates[0], 0.3 / 2.0 * (t - time * (1.0 - gone)), 4e-9);
    EXPECT_NEAR(motion[i].angles[0], 0.3 / 2.0 * (0.5 * t * t - time * t + time * time * (1.0 - gone)), 8e-9);
  }
}

// A lag far below anything of interest: after its end it is as if it were not there but for the shift by T, and it does
// not hold the integrator to steps of its own length (which would take 1e7 of them here).
TEST(SimulateEffects, CopesWithALagOfMicroseconds) {
  const double time = 2e-6;
  const Model model = sample::rig({.inertia = 2.0, .stiffness = 50.0, .damping = 1.0}, {{&sample::lag, {time}}});
  const Model prompt = sample::rig({.inertia = 2.0, .stiffness = 50.0, .damping = 1.0}, {});
  const ModelInput input = step_input(model, {.current = 0.3, .duration = 30.0, .interval = 0.1});
  const std::vector<State> late = simulate(model, input, at_rest_with(model, 0.0));
  const std::vector<State> sharp = simulate(prompt, input, at_rest(prompt));
  for (std::size_t i = 0; i < late.size(); ++i)
    EXPECT_NEAR(late[i].angles[0], sharp[i].angles[0], 0.03 * time + 1e-8);  // speed at most 0.03 rad/s
}

TEST(SimulateEffects, SettlesAStartWithoutInternalStatesUnderTheFirstInput) {
  const Model model = sample::rig({.inertia = 2.0, .stiffness = 1.0}, {{&sample::lag, {0.1}}});
  const ModelInput input = step_input(model, {.current = 0.3, .duration = 0.2, .interval = 0.1});
  const std::vector<State> motion = simulate(model, input, at_rest(model));
  for (const State& state : motion) EXPECT_EQ(state.internal[0], 0.3);
  EXPECT_EQ(error_text([&] {
              State start = at_rest(model);
              start.internal = Eigen::VectorXd::Zero(3);
              (void)simulate(model, input, start);
            }),
            "start: 1 states of the effects are needed, or none; got 3");
}

// x' = A x + c over (theta, omega, xi), with the exponential of the matrix that has c as a further column.
TEST(SimulateEffects, FollowsCreepAsItsMatrixExponentialSays) {
  const double inertia = 2.0;
  const double k = 30.0;
  const double b = 1.5;
  const double branch = 12.0;
  const double time = 0.4;
  const Model model =
      sample::rig({.inertia = inertia, .stiffness = k, .damping = b}, {{&sample::creep, {branch, time, 0.0}}});
  const double torque = 5.0;
  Eigen::Matrix4d system;
  system << 0.0, 1.0, 0.0, 0.0,                                                   //
      -(k + branch) / inertia, -b / inertia, branch / inertia, torque / inertia,  //
      1.0 / time, 0.0, -1.0 / time, 0.0,                                          //
      0.0, 0.0, 0.0, 0.0;
  const ModelInput input = step_input(model, {.current = torque, .duration = 4.0, .interval = 0.05});
  const std::vector<State> motion = simulate(model, input, at_rest(model), {.relative = 1e-10});
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Eigen::Matrix4d flow = (system * input.times[i]).exp();
    EXPECT_NEAR(motion[i].angles[0], flow(0, 3), 2e-9);
    EXPECT_NEAR(motion[i].rates[0], flow(1, 3), 1e-8);
    EXPECT_NEAR(motion[i].internal[0], flow(2, 3), 2e-9);
  }
}

// Work of the coil = energy of motion, springs and branch + what the two dampers took: the branch's takes
// (k_branch T) xi'^2.
TEST(SimulateEffects, BalancesTheEnergyOfCreep) {
  const double branch = 6e-3;
  const double time = 0.03;
  const Model bare = finger(actuator::Configuration::B).model;
  const Model model = sample::with_effects(bare, {{&sample::creep, {branch, time, 0.0}}});
  const actuator::CoilCurrents currents = model.all_coils(1.4);
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput input = step_input(model, {.current = 1.4, .duration = 0.2, .interval = 1e-4});
  const std::vector<State> motion = simulate(model, input, start, {.relative = 1e-10});
  const auto power = [&](const State& state) {
    JointVector magnetic = straight(model);
    model.magnetics().add_torques(model.chain(), state.angles, currents, magnetic);
    const Eigen::VectorXd stretch = state.angles - state.internal;
    return magnetic.dot(state.rates) - model.damping(state.angles).dot(state.rates.cwiseProduct(state.rates)) -
           branch / time * stretch.squaredNorm();
  };
  const auto energy = [&](const State& state) {
    return energy_of(model, state) + 0.5 * branch * (state.angles - state.internal).squaredNorm();
  };
  double work = 0.0;
  double largest_stretch = 0.0;
  for (std::size_t i = 2; i < motion.size(); i += 2) {
    work += 1e-4 / 3.0 * (power(motion[i - 2]) + 4.0 * power(motion[i - 1]) + power(motion[i]));
    largest_stretch = std::max(largest_stretch, (motion[i].angles - motion[i].internal).norm());
  }
  EXPECT_GT(largest_stretch, 0.1);
  EXPECT_GT(std::abs(work), 1e-3);
  EXPECT_NEAR(energy(motion.back()) - energy(motion.front()), work, 1e-8 * std::abs(work));  // Simpson's own error
}

// A gain before the force is the same as more current, whether drive or magnetics have it; both together multiply.
TEST(SimulateEffects, TakesAGainAsMoreCurrent) {
  const Model bare = finger(actuator::Configuration::B).model;
  const State start{.angles = rest_of(bare), .rates = straight(bare)};
  const std::vector<State> plain =
      simulate(bare, step_input(bare, {.current = 1.2, .duration = 0.2, .interval = 0.01}), start);
  const auto expect_same = [&](std::vector<Effect> effects, double current) {
    const Model model = sample::with_effects(bare, std::move(effects));
    const std::vector<State> motion =
        simulate(model, step_input(model, {.current = current, .duration = 0.2, .interval = 0.01}), start);
    for (std::size_t i = 0; i < motion.size(); ++i)
      EXPECT_LT((motion[i].angles - plain[i].angles).lpNorm<Eigen::Infinity>(), 1e-12);
  };
  expect_same({{&sample::drive_gain, {0.8}}}, 1.5);
  expect_same({{&sample::force_gain, {1.5}}}, 0.8);
  expect_same({{&sample::force_gain, {0.5}}, {&sample::drive_gain, {2.0}}}, 1.2);
}

// Each stage of the drive sees what the one before it gives: a lag behind a gain ends at the amplified current.
TEST(SimulateEffects, PassesTheDriveInARow) {
  const Model model = sample::rig({.stiffness = 1.0}, {{&sample::drive_gain, {3.0}}, {&sample::lag, {0.01}}});
  const Model turned = sample::rig({.stiffness = 1.0}, {{&sample::lag, {0.01}}, {&sample::drive_gain, {3.0}}});
  EXPECT_DOUBLE_EQ(model.settled(straight(model), model.all_coils(0.2))[0], 0.6);
  EXPECT_DOUBLE_EQ(turned.settled(straight(turned), turned.all_coils(0.2))[0], 0.2);
  // The pair's constant curve is a sum of Chebyshev polynomials: a few tens of roundings.
  EXPECT_NEAR(model.static_residual(straight(model), model.all_coils(0.2))[0], 0.6, 1e-14);
  EXPECT_NEAR(turned.static_residual(straight(turned), turned.all_coils(0.2))[0], 0.6, 1e-14);
}

TEST(SimulateEffects, IsBitForBitTheSameWithAnEffectThatDoesNothing) {
  const Model bare = finger(actuator::Configuration::B).model;
  const Model model = sample::with_effects(bare, {{&sample::nothing, {}}});
  const State start{.angles = rest_of(bare), .rates = straight(bare)};
  const ModelInput input =
      sine_input(bare, {.amplitude = 0.7, .offset = 0.7, .frequency = 3.0, .duration = 0.5, .interval = 2e-3});
  const std::vector<State> with = simulate(model, input, start);
  const std::vector<State> without = simulate(bare, input, start);
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].angles, without[i].angles);
    EXPECT_EQ(with[i].rates, without[i].rates);
  }
}

// -c theta'^3 at every joint.
class CubicDrag : public actuator::EffectTerm {
 public:
  CubicDrag(std::span<const double> values, const actuator::ModelSpec& spec)
      : coefficient_(values[0]), joints_(spec.chain.joints()) {}
  void add_torques(const Kinematics& motion, const actuator::CoilCurrents& /*strength*/, InternalStateView /*own*/,
                   JointVector& torques) const override {
    for (int j = 0; j < joints_; ++j) torques[j] -= coefficient_ * std::pow(motion.rates[j], 3);
  }

 private:
  double coefficient_;
  int joints_;
};
const sample::Kind cubic_drag =
    sample::kind_of<CubicDrag>("sample_cubic_drag", actuator::Stage::hinge, {sample::number("coefficient")});

// After a rest the first trial step into a motion is far too long, and overflows in such a term. It is to be taken
// shorter, not to be believed.
TEST(SimulateEffects, FollowsAStrongDragThatOverflowsInATrialStep) {
  for (const double coefficient : {2e-7, 1e-4, 1e-3, 1e-2}) {  // N m s^3/rad^3
    Model::Spec spec = finger(actuator::Configuration::B).model.nominal_spec();
    spec.effects = {{&cubic_drag, {coefficient}}};
    const Model model(std::move(spec));
    const State start{.angles = rest_of(model), .rates = straight(model)};
    ModelInput input;
    input.times = {0.0, 20.0, 20.1};
    input.currents = {model.all_coils(0.0), model.all_coils(1.4), model.all_coils(1.4)};
    const State end = simulate(model, input, start).back();
    State state = start;
    for (int i = 0; i < 20000; ++i) state = rk4_step(model, model.all_coils(1.4), state, 5e-6);
    EXPECT_LT((end.angles - state.angles).lpNorm<Eigen::Infinity>(), 1e-6) << coefficient;
    EXPECT_LT((end.rates - state.rates).lpNorm<Eigen::Infinity>(), 1e-4) << coefficient;
  }
}

}  // namespace
}  // namespace coilwright::simulation
