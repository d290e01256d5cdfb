#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>

#include "actuator/sample_effects.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/modes.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/step_response.hpp"
#include "coilwright/simulation/transient.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

namespace sample = actuator::sample;

// A rig with creep, by equations and an integrator of this test's own: theta, omega, xi.
struct CreepingRig {
  double inertia = 2.0;
  double stiffness = 200.0;
  double damping = 4.0;
  double branch = 80.0;
  double time = 0.3;

  void operator()(const std::array<double, 3>& x, std::array<double, 3>& slope, double /*t*/) const {
    slope[0] = x[1];
    slope[1] = (torque - stiffness * x[0] - damping * x[1] - branch * (x[0] - x[2])) / inertia;
    slope[2] = (x[0] - x[2]) / time;
  }
  double torque = 60.0;
};

Model model_of(const CreepingRig& rig, double slow) {
  return sample::rig({.inertia = rig.inertia, .stiffness = rig.stiffness, .damping = rig.damping},
                     {{&sample::creep, {rig.branch, rig.time, slow}}});
}

struct Figures {
  double peak_speed = 0.0;
  double overshoot = 0.0;
  double tenth = -1.0;
  double ninth = -1.0;
  double settling = 0.0;
};

Figures integrated(const CreepingRig& rig, double end) {
  namespace odeint = boost::numeric::odeint;
  std::array<double, 3> x{};
  Figures out;
  constexpr double interval = 1e-5;
  const auto watch = [&](const std::array<double, 3>& state, double t) {
    out.peak_speed = std::max(out.peak_speed, std::abs(state[1]));
    out.overshoot = std::max(out.overshoot, state[0] / end - 1.0);
    if (out.tenth < 0.0 && state[0] >= 0.1 * end) out.tenth = t;
    if (out.ninth < 0.0 && state[0] >= 0.9 * end) out.ninth = t;
    if (std::abs(state[0] / end - 1.0) > 0.02) out.settling = t;
  };
  const auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<std::array<double, 3>>>(1e-13, 1e-13);
  odeint::integrate_const(stepper, rig, x, 0.0, 6.0, interval, watch);
  return out;
}

void expect_as_integrated(const StepResponse& step, const Figures& reference) {
  // A step's tolerance, and a sample of the reference.
  EXPECT_NEAR(step.peak_speed, reference.peak_speed, 1e-5 * reference.peak_speed);
  EXPECT_NEAR(step.overshoot, reference.overshoot, 2e-5);
  EXPECT_NEAR(*step.rise_time, reference.ninth - reference.tenth, 3e-5);
  EXPECT_NEAR(*step.settling_time, reference.settling, 3e-5 + 1e-4 * reference.settling);
}

TEST(StepEffects, OfCreepIsWhatAnotherIntegratorMeasures) {
  const CreepingRig rig;
  const Model model = model_of(rig, 0.0);
  const auto step = step_response(model, model.all_coils(rig.torque), straight(model));
  ASSERT_TRUE(step && step->rise_time && step->settling_time);
  EXPECT_NEAR(step->steady_angles[0], rig.torque / rig.stiffness, 1e-10);
  expect_as_integrated(*step, integrated(rig, rig.torque / rig.stiffness));
}

// Slow creep stays at rest during the step: the branch is a spring.
TEST(StepEffects, HoldsSlowCreepInAStep) {
  CreepingRig rig;
  const Model model = model_of(rig, 1.0);
  const MotionSummary motion = std::get<MotionSummary>(motion_of(model, rig.torque));
  rig.time = 1e30;
  const double end = rig.torque / (rig.stiffness + rig.branch);
  EXPECT_NEAR(motion.steady_angles[0], end, 1e-10);
  const Figures reference = integrated(rig, end);
  EXPECT_NEAR(motion.peak_bending_speed, reference.peak_speed, 1e-5 * reference.peak_speed);
  EXPECT_NEAR(motion.overshoot, reference.overshoot, 2e-5);
  // And its tip presses with that spring turned no way: straight, the branch is at rest.
  EXPECT_NEAR(motion.grasp_force, rig.torque, 1e-6 * rig.torque);
  ASSERT_EQ(motion.modes.size(), 1U);
  EXPECT_NEAR(motion.modes[0].natural_frequency,
              std::sqrt((rig.stiffness + rig.branch) / rig.inertia) / (2.0 * std::numbers::pi), 1e-6);
}

// Dry friction of a spring and a mass without another loss: each half swing is 2 tau_c / k shorter than the one before,
// and it stands in the first turning point within tau_c / k of where the spring is at rest. (Bristles that give by a
// hundred-thousandth of the swing stand for Coulomb's law, to that share.)
TEST(StepEffects, StandsWhereFrictionHoldsIt) {
  const double k = 200.0;
  const double friction = 7.0;
  const double torque = 60.0;
  const Model model =
      sample::rig({.inertia = 2.0, .stiffness = k, .damping = 0.0}, {{&sample::friction, {friction, 3e-6}}});
  const auto step = step_response(model, model.all_coils(torque), straight(model));
  ASSERT_TRUE(step);
  double swing = torque / k;  // from the middle, the start on the other side
  double side = -1.0;
  while (swing > friction / k) {
    swing -= 2.0 * friction / k;
    side = -side;
  }
  EXPECT_NEAR(step->steady_angles[0], torque / k + side * swing, 3e-4 * torque / k);
  EXPECT_GT(std::abs(swing), 0.02 * torque / k);
  // Half a swing of a mass on a spring about (torque - friction) / k.
  EXPECT_NEAR(step->peak_speed, (torque - friction) / k * std::sqrt(k / 2.0), 1e-3 * step->peak_speed);
}

TEST(StepEffects, OfALaggingFingerIsWhatBruteForceMeasures) {
  const Model bare = finger(actuator::Configuration::B).model;
  const Model model = sample::with_effects(
      bare, {{&sample::lag, {8e-3}}, {&sample::creep, {3e-3, 0.05, 0.0}}, {&sample::spring_damper, {1e-3, 2e-5}}});
  const JointVector rest = find_equilibrium(model, model.all_coils(0.0), straight(model)).value();
  const auto step = step_response(model, model.all_coils(1.4), rest);
  ASSERT_TRUE(step && step->settling_time && step->rise_time);
  constexpr double interval = 1e-4;
  const ModelInput input = step_input(model, {.current = 1.4, .duration = 3.0, .interval = interval});
  const State start{.angles = rest, .rates = straight(model), .internal = model.settled(rest, model.all_coils(0.0))};
  const std::vector<State> motion = simulate(model, input, start, {.relative = 1e-9});
  EXPECT_LT((motion.back().angles - step->steady_angles).lpNorm<Eigen::Infinity>(), 1e-7);
  const double change = (step->steady_angles - rest).sum();
  double peak = 0.0;
  double settled = 0.0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    peak = std::max(peak, motion[i].rates.sum());
    if (std::abs((motion[i].angles - step->steady_angles).sum()) > 0.02 * change) settled = input.times[i];
  }
  EXPECT_NEAR(step->peak_speed, peak, 3e-5 * peak);  // the samples' part: (omega interval)^2 / 8
  EXPECT_NEAR(*step->settling_time, settled, 2.0 * interval);
  EXPECT_LT(step->peak_speed, 0.95 * step_response(bare, bare.all_coils(1.4), rest_of(bare))->peak_speed);
}

// (s^2 J + s b + k + branch s T / (1 + s T)) = 0 over s: the roots of a cubic, its real one the creep's own.
TEST(ModesEffects, AreTheRootsOfTheCharacteristicEquation) {
  const CreepingRig rig;
  const Model model = model_of(rig, 0.0);
  const std::vector<Mode> found = modes(model, straight(model), model.all_coils(0.0));
  ASSERT_EQ(found.size(), 1U);
  const double size = 2.0 * std::numbers::pi * found[0].natural_frequency;
  const std::complex<double> s =
      size * std::complex<double>(-found[0].damping_ratio, std::sqrt(1.0 - std::pow(found[0].damping_ratio, 2)));
  const std::complex<double> residual =
      s * s * rig.inertia + s * rig.damping + rig.stiffness + rig.branch * s * rig.time / (1.0 + s * rig.time);
  EXPECT_LT(std::abs(residual), 1e-6 * rig.stiffness);
}

// Overdamped and with creep, there are three real roots; the chain keeps two modes.
TEST(ModesEffects, LeaveTheEffectsOwnRatesOut) {
  CreepingRig rig;
  rig.damping = 90.0;
  rig.branch = 1e-3;  // hardly coupled: the chain's two rates are those without it
  const Model model = model_of(rig, 0.0);
  const std::vector<Mode> found = modes(model, straight(model), model.all_coils(0.0));
  ASSERT_EQ(found.size(), 2U);
  const double root = std::sqrt(rig.damping * rig.damping - 4.0 * rig.inertia * rig.stiffness);
  EXPECT_NEAR(2.0 * std::numbers::pi * found[0].natural_frequency, (rig.damping - root) / (2.0 * rig.inertia), 1e-3);
  EXPECT_NEAR(2.0 * std::numbers::pi * found[1].natural_frequency, (rig.damping + root) / (2.0 * rig.inertia), 1e-3);
}

// Bristles stiffen what is smaller than their give; a mode is a motion beyond that.
TEST(ModesEffects, DoNotKnowFriction) {
  const Model bare = finger(actuator::Configuration::B).model;
  const Model model = sample::with_effects(bare, {{&sample::friction, {2e-4, 1e-3}}});
  const JointVector angles = rest_of(bare);
  const std::vector<Mode> with = modes(model, angles, model.all_coils(0.0));
  const std::vector<Mode> without = modes(bare, angles, bare.all_coils(0.0));
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_NEAR(with[i].natural_frequency, without[i].natural_frequency, 1e-9 * without[i].natural_frequency);
    EXPECT_NEAR(with[i].damping_ratio, without[i].damping_ratio, 1e-9);
  }
}

// A gain of the force is a gain of the current to every figure of a performance.
TEST(PerformanceEffects, TakeAGainAsMoreCurrent) {
  actuator::Design design = actuator::paper_finger();
  const auto performance = [&](double current) {
    return std::get<Performance>(performance_of(design, actuator::assemble_or_throw(design), {.current = current}));
  };
  const Performance plain = performance(1.2);
  design.effects = {{&sample::force_gain, {1.5}}};
  const Performance gained = performance(0.8);
  EXPECT_NEAR(gained.axial_force, plain.axial_force, 1e-12);
  EXPECT_NEAR(gained.cold.peak_bending_speed, plain.cold.peak_bending_speed, 1e-9);
  EXPECT_NEAR(gained.cold.grasp_force, plain.cold.grasp_force, 1e-9);
  // Two ways of seeing when it has settled, the same time.
  EXPECT_NEAR(*gained.cold.settling_time, *plain.cold.settling_time, 1e-9);
  EXPECT_NEAR(gained.electrics_cold.voltage.value(), plain.electrics_cold.voltage.value() / 1.5, 1e-12);
}

// What one would start a fit from is a finger that still moves: with each effect of the catalogue it has a performance,
// and its step ends where a long run ends up to what friction leaves open.
TEST(PerformanceEffects, AreThereForEveryEffectOfTheCatalogue) {
  const actuator::Design design = actuator::paper_finger();
  const actuator::RigScale scale{.torque = 5e-3,
                                 .angle = 0.4,
                                 .rate = 15.0,
                                 .current = 1.4,
                                 .interval = 2e-3,
                                 .duration = 15.0,
                                 .mean_angle = 0.3,
                                 .upper_angle = 0.6,
                                 .lower_angle = 0.1};
  const actuator::ModelSpec nominal = actuator::assemble_or_throw(design).model.nominal_spec();
  int there = 0;
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
    if (kind->inapplicable(nominal)) continue;
    ++there;
    for (const std::vector<double>& values : kind->starts(scale)) {
      actuator::Design changed = design;
      changed.effects = {{kind, values}};
      const Model model = actuator::assemble_or_throw(changed).model;
      const std::variant<MotionSummary, NoPerformance> result = motion_of(model, 1.4);
      const MotionSummary* motion = std::get_if<MotionSummary>(&result);
      ASSERT_NE(motion, nullptr) << kind->id() << ": " << std::get<NoPerformance>(result).reason;
      const State start{.angles = motion->rest_angles, .rates = straight(model)};
      const Model cold = model.with_slow_states_held(model.settled(start.angles, model.all_coils(0.0)));
      ModelInput step;
      step.times = {0.0, 1e-9, 15.0};
      step.currents = {model.all_coils(0.0), model.all_coils(1.4), model.all_coils(1.4)};
      const JointVector end = simulate(cold, step, start).back().angles;
      EXPECT_LT((end - motion->steady_angles).lpNorm<Eigen::Infinity>(), 1e-3) << kind->id() << ' ' << values.size();
    }
  }
  EXPECT_GE(there, 20);
}

// Friction that holds a joint off its equilibrium, and bodies that ring beside it: the step ends all the same.
TEST(PerformanceEffects, AreThereForFrictionBesideBodies) {
  const auto kind = [](std::string_view id) { return actuator::standard_effects().find(id); };
  actuator::Design design = actuator::paper_finger();
  design.effects = {{kind("dry_friction"), {0.2e-3}}};
  const auto motion = [&] {
    return std::get<MotionSummary>(motion_of(actuator::assemble_or_throw(design).model, 1.2));
  };
  const MotionSummary firm = motion();
  design.effects.push_back({kind("backlash"), {0.5 / 57.3}});
  design.effects.push_back({kind("mount_compliance"), {60.0, 0.3}});
  const MotionSummary loose = motion();
  // Within what friction leaves open, tau_c / k = 16 mrad.
  EXPECT_LT((loose.steady_angles - firm.steady_angles).lpNorm<Eigen::Infinity>(), 0.016);
  EXPECT_NE(loose.peak_bending_speed, firm.peak_bending_speed);
}

// The camera shows a * angle + b of a while ago, and the start before that.
TEST(SimulateSeen, IsLateAndAsTheCameraShowsIt) {
  const Model bare = finger(actuator::Configuration::B).model;
  const double delay = 0.0337;
  const Model model = sample::with_effects(bare, {{&sample::camera, {1.1, 0.02, delay}}});
  const State start{.angles = rest_of(bare), .rates = straight(bare)};
  const ModelInput input = step_input(bare, {.current = 1.4, .duration = 0.2, .interval = 0.01});
  const std::vector<State> seen = simulate_as_observed(model, input, start);
  ASSERT_EQ(seen.size(), input.times.size());
  EXPECT_EQ(seen[3].angles, start.angles);
  const ModelInput fine = step_input(bare, {.current = 1.4, .duration = 0.2, .interval = 1e-4});
  const std::vector<State> motion = simulate(bare, fine, start);
  for (std::size_t i = 4; i < seen.size(); ++i) {
    const auto sample = static_cast<std::size_t>(std::lround((input.times[i] - delay) / 1e-4));
    EXPECT_LT((seen[i].angles - motion[sample].angles).lpNorm<Eigen::Infinity>(), 1e-12);
  }
  EXPECT_DOUBLE_EQ(model.observed(0.5), 0.57);
}

// A record that is stamped too early shows what is still to come, after its end under the last input.
TEST(SimulateSeen, MayBeEarly) {
  const Model bare = finger(actuator::Configuration::B).model;
  const double ahead = 0.0241;
  const Model model = sample::with_effects(bare, {{&sample::camera, {1.0, 0.0, -ahead}}});
  const State start{.angles = rest_of(bare), .rates = straight(bare)};
  const ModelInput input = step_input(bare, {.current = 1.4, .duration = 0.1, .interval = 0.01});
  const std::vector<State> seen = simulate_as_observed(model, input, start);
  ASSERT_EQ(seen.size(), input.times.size());
  const ModelInput fine = step_input(bare, {.current = 1.4, .duration = 0.2, .interval = 1e-4});
  const std::vector<State> motion = simulate(bare, fine, start);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto sample = static_cast<std::size_t>(std::lround((input.times[i] + ahead) / 1e-4));
    EXPECT_LT((seen[i].angles - motion[sample].angles).lpNorm<Eigen::Infinity>(), 1e-12);
  }
}

// The same of a current that goes straight to its last row, where it is held.
TEST(SimulateSeen, MayBeEarlyUnderAStraightInput) {
  const Model bare = finger(actuator::Configuration::B).model;
  const double ahead = 0.03;
  const Model model = sample::with_effects(bare, {{&sample::camera, {1.0, 0.0, -ahead}}});
  const State start{.angles = rest_of(bare), .rates = straight(bare)};
  const ModelInput ramp{.times = {0.0, 0.05, 0.1},
                        .currents = {bare.all_coils(0.0), bare.all_coils(0.6), bare.all_coils(1.2)},
                        .straight = {1, 1, 0}};
  ModelInput longer = ramp;
  longer.times.push_back(0.1 + ahead);
  longer.currents.push_back(longer.currents.back());
  longer.straight.push_back(0);
  const State at_last = simulate_as_observed(model, ramp, start).back();
  EXPECT_LT((at_last.angles - simulate(bare, longer, start).back().angles).lpNorm<Eigen::Infinity>(), 1e-12);
}

}  // namespace
}  // namespace coilwright::simulation
