#include "coilwright/simulation/transient.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;

double largest_difference(const State& a, const State& b) {
  return std::max((a.angles - b.angles).lpNorm<Eigen::Infinity>(),
                  1e-2 * (a.rates - b.rates).lpNorm<Eigen::Infinity>());  // rates reach a hundred times the angles
}

// A second integrator must come to the same motion, and the closer the finer its steps are, at its own order: 16 times
// a halving, until what is left is the first one's error.
TEST(Simulate, IsWhatAFixedStepIntegratorComesTo) {
  const Model model = finger(Configuration::B).model;
  const actuator::CoilCurrents currents = model.all_coils(1.4);
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput input = step_input(model, {.current = 1.4, .duration = 0.1, .interval = 0.1});
  const State end = simulate(model, input, start, {.relative = 1e-10}).back();
  double before = 0.0;
  for (const int steps : {100, 200, 400}) {
    State state = start;
    for (int i = 0; i < steps; ++i) state = rk4_step(model, currents, state, 0.1 / steps);
    const double error = largest_difference(state, end);
    if (before > 0.0) {
      EXPECT_LT(error, before / 10.0);
    }
    before = error;
  }
  EXPECT_LT(before, 2e-6);
}

TEST(Simulate, ErrsByLessAtATighterTolerance) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput input = step_input(model, {.current = 1.4, .duration = 0.4, .interval = 0.4});
  const State best = simulate(model, input, start, {.relative = 1e-12}).back();
  const double loose = largest_difference(simulate(model, input, start, {.relative = 1e-5}).back(), best);
  const double standard = largest_difference(simulate(model, input, start).back(), best);
  EXPECT_LT(standard, 0.1 * loose);
  EXPECT_LT(standard, 1e-6);  // of half a radian, after three periods at 1e-7 a step
}

TEST(Simulate, AnswersAtEverySampleWhateverTheirSpacing) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  ModelInput sparse;
  sparse.times = {0.0, 0.033, 0.035, 0.2};
  sparse.currents.assign(4, model.all_coils(1.1));
  const ModelInput dense = step_input(model, {.current = 1.1, .duration = 0.2, .interval = 1e-3});
  const std::vector<State> few = simulate(model, sparse, start);
  const std::vector<State> many = simulate(model, dense, start);
  ASSERT_EQ(few.size(), 4U);
  ASSERT_EQ(many.size(), 201U);
  EXPECT_EQ(few[0].angles, start.angles);
  // The integrator does not see the samples, so the same instants give the same bits but for the sums of intervals.
  EXPECT_LT(largest_difference(few[1], many[33]), 1e-12);
  EXPECT_LT(largest_difference(few[2], many[35]), 1e-12);
  EXPECT_LT(largest_difference(few[3], many[200]), 1e-12);
}

// Held until the next sample: a pulse is two runs with constant input, one after the other.
TEST(Simulate, HoldsTheInputBetweenSamples) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  ModelInput pulse;
  pulse.times = {0.0, 0.02, 0.07};
  pulse.currents = {model.all_coils(1.4), model.all_coils(-0.3), model.all_coils(99.0)};
  pulse.joint_torques = {straight(model), JointVector::Constant(2, 2e-3), straight(model)};
  const std::vector<State> both = simulate(model, pulse, start, {.relative = 1e-10});

  State state = start;
  for (int i = 0; i < 2000; ++i) state = rk4_step(model, model.all_coils(1.4), state, 1e-5);
  EXPECT_LT(largest_difference(both[1], state), 1e-8);
  ModelInput second;
  second.times = {0.0, 0.05};
  second.currents.assign(2, model.all_coils(-0.3));
  second.joint_torques.assign(2, JointVector::Constant(2, 2e-3));
  EXPECT_LT(largest_difference(both[2], simulate(model, second, both[1], {.relative = 1e-10}).back()), 1e-8);
}

// What the finger has lost is what its dampers took less what its coils gave. Simpson's rule over samples every 0.1 ms.
// A finger that has rested for long has been followed in long steps; the jump that ends it needs short ones at once.
TEST(Simulate, FollowsAJumpAfterALongRestAsOneAtTheBeginning) {
  actuator::Design design;
  design.layout = actuator::layout_of(Configuration::B);
  design.choices.faces = actuator::ContactChoice::hard_parts;
  const actuator::ModelSpec spec = actuator::assemble_or_throw(design).model.nominal_spec();
  int cases = 0;
  for (const double turned : {0.0, 0.5 * std::numbers::pi + 0.05, std::numbers::pi}) {
    actuator::ModelSpec turned_spec = spec;
    turned_spec.chain = spec.chain.under_gravity(spec.chain.gravity(), spec.chain.base_tilt() + turned);
    const Model model(turned_spec);
    const auto start = state_at_rest(model, model.all_coils(0.0), straight(model));
    if (!start) continue;
    for (const double current : {-0.7, 0.35, 0.7, 1.4}) {
      const ModelInput jump{.times = {0.0, 0.1}, .currents = {model.all_coils(current), model.all_coils(current)}};
      const State best = simulate(model, jump, *start, {.relative = 1e-11}).back();
      for (const double rest : {0.05, 0.5, 3.0}) {
        const ModelInput input{.times = {0.0, rest, rest + 0.1},
                               .currents = {model.all_coils(0.0), model.all_coils(current), model.all_coils(current)}};
        for (const bool ends_at_rest : {false, true})
          EXPECT_LT(largest_difference(
                        simulate(model, input, *start, {.relative = 1e-6, .ends_at_rest = ends_at_rest}).back(), best),
                    2e-4)
              << turned << " rad, " << current << " A, " << rest << " s";
        ++cases;
      }
    }
  }
  EXPECT_GT(cases, 20);
}

// That the states of ever more parts, each twice as many, come to `end` as a method of second order does, and near it.
template <typename StateOf>
void expect_second_order(const State& end, std::initializer_list<int> numbers_of_parts, const StateOf& state_of) {
  double before = 0.0;
  for (const int parts : numbers_of_parts) {
    const double error = largest_difference(state_of(parts), end);
    if (before > 0.0) {
      EXPECT_LT(error, before / 3.0) << parts;
    }
    before = error;
  }
  EXPECT_LT(before, 1e-5);
}

// A straight input is the limit of ever finer steps, each at the level in its middle.
TEST(Simulate, GoesStraightBetweenSamplesWhereTheInputDoes) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput line{
      .times = {0.0, 0.05, 0.12, 0.2},
      .currents = {model.all_coils(0.0), model.all_coils(1.4), model.all_coils(0.5), model.all_coils(0.5)},
      .straight = {1, 1, 0, 0}};
  const auto stairs_of = [&](int parts) {
    ModelInput stairs;
    const auto add = [&](double from, double to, double first, double last) {
      for (int k = 0; k < parts; ++k) {
        stairs.times.push_back(from + (to - from) * k / parts);
        stairs.currents.push_back(model.all_coils(first + (last - first) * (k + 0.5) / parts));
      }
    };
    add(0.0, 0.05, 0.0, 1.4);
    add(0.05, 0.12, 1.4, 0.5);
    stairs.times.insert(stairs.times.end(), {0.12, 0.2});
    stairs.currents.insert(stairs.currents.end(), 2, model.all_coils(0.5));
    return stairs;
  };
  const Accuracy fine{.relative = 1e-10};
  expect_second_order(simulate(model, line, start, fine).back(), {50, 100, 200},
                      [&](int parts) { return simulate(model, stairs_of(parts), start, fine).back(); });
}

// A smooth curve through rows that are passed, here a parabola, is the limit of straight lines between ever more.
TEST(Simulate, PassesRowsWithoutACorner) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const auto input = [&](int parts, bool passed) {
    ModelInput out;
    for (int k = 0; k <= parts; ++k) {
      const double time = 0.1 * k / parts;
      out.times.push_back(time);
      out.currents.push_back(model.all_coils(0.3 + 20.0 * time - 150.0 * time * time));
      out.straight.push_back(k < parts ? 1 : 0);
      out.passed.push_back(passed && k > 0 && k < parts ? 1 : 0);
    }
    return out;
  };
  const Accuracy fine{.relative = 1e-10};
  const State end = simulate(model, input(4, true), start, fine).back();
  EXPECT_LT(largest_difference(simulate(model, input(7, true), start, fine).back(), end), 1e-8);
  expect_second_order(end, {25, 50, 100, 200},
                      [&](int parts) { return simulate(model, input(parts, false), start, fine).back(); });
}

// The closed form of a short lag under a curve, and the integrator's own way with a longer one, are the limit of the
// closed form under ever finer steps.
TEST(Simulate, KnowsTheLagOfACurrentThatFollowsACurve) {
  for (const double lag : {3e-4, 1.9e-3, 5e-3}) {
    actuator::Design design;
    design.layout = actuator::layout_of(Configuration::B);
    design.effects = {{actuator::standard_effects().find("coil_lag"), {lag}}};
    const Model model = actuator::assemble_or_throw(design).model;
    const State start{.angles = rest_of(model), .rates = straight(model)};
    const auto current = [](double time) { return 0.7 + 0.5 * std::sin(40.0 * time); };
    ModelInput curve;
    for (int k = 0; k <= 100; ++k) {
      curve.times.push_back(0.001 * k);
      curve.currents.push_back(model.all_coils(current(curve.times.back())));
      curve.straight.push_back(k < 100 ? 1 : 0);
      curve.passed.push_back(k > 0 && k < 100 ? 1 : 0);
    }
    const Accuracy fine{.relative = 1e-9};
    const State end = simulate(model, curve, start, fine).back();
    expect_second_order(end, {100, 200, 400}, [&](int parts) {
      ModelInput stairs;
      for (int k = 0; k <= parts; ++k) {
        stairs.times.push_back(0.1 * k / parts);
        stairs.currents.push_back(model.all_coils(current(0.1 * (k + 0.5) / parts)));
      }
      State first = start;
      first.internal = actuator::InternalStates::Constant(model.internal_states(), current(0.0));
      return simulate(model, stairs, first, fine).back();
    });
    EXPECT_NEAR(end.internal[0], simulate(model, curve, start, {.relative = 1e-6}).back().internal[0], 1e-5);
  }
}

TEST(Simulate, RefusesToPassWhereTheInputIsHeld) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput input{.times = {0.0, 0.1, 0.2},
                         .currents = std::vector<actuator::CoilCurrents>(3, model.all_coils(1.0)),
                         .straight = {1, 0, 0},
                         .passed = {0, 1, 0}};
  try {
    (void)simulate(model, input, start, {.relative = 1e-6});
    FAIL();
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(refused.what(),
                 "input: sample 1 is passed without a corner, and the input does not go straight on both sides of it");
  }
}

TEST(Simulate, MayEndAtRest) {
  const Model model = finger(Configuration::B).model;
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput input = step_input(model, {.current = 1.0, .duration = 20.0, .interval = 0.5});
  const std::vector<State> followed = simulate(model, input, start, {.relative = 1e-6});
  const std::vector<State> ended = simulate(model, input, start, {.relative = 1e-6, .ends_at_rest = true});
  ASSERT_EQ(followed.size(), ended.size());
  for (std::size_t i = 0; i < ended.size(); ++i)
    EXPECT_LT((followed[i].angles - ended[i].angles).lpNorm<Eigen::Infinity>(), 5e-6) << i;
  EXPECT_EQ(ended[30].angles, ended[40].angles);
}

TEST(Simulate, BalancesItsEnergy) {
  const Model model = finger(Configuration::B).model;
  const actuator::CoilCurrents currents = model.all_coils(1.4);
  const State start{.angles = rest_of(model), .rates = straight(model)};
  const ModelInput input = step_input(model, {.current = 1.4, .duration = 0.2, .interval = 1e-4});
  const std::vector<State> motion = simulate(model, input, start, {.relative = 1e-10});
  const auto power = [&](const State& state) {
    JointVector magnetic = straight(model);
    model.magnetics().add_torques(model.chain(), state.angles, currents, magnetic);
    return magnetic.dot(state.rates) - model.damping(state.angles).dot(state.rates.cwiseProduct(state.rates));
  };
  double work = 0.0;
  for (std::size_t i = 2; i < motion.size(); i += 2)
    work += 1e-4 / 3.0 * (power(motion[i - 2]) + 4.0 * power(motion[i - 1]) + power(motion[i]));
  const double gained = energy_of(model, motion.back()) - energy_of(model, start);
  EXPECT_GT(std::abs(work), 1e-3);
  EXPECT_NEAR(gained, work, 1e-8 * std::abs(work));  // (1e-4 s / 10 ms)^4: Simpson's own error
}

// Without damping and current a C keeps its energy, its magnets' attraction and its lossless stops included.
TEST(Simulate, KeepsTheEnergyOfAFingerWithoutLosses) {
  const Model model = with_hinges(finger(Configuration::C).model, [](actuator::Hinge& hinge) {
    hinge.damping = 0.0;
    hinge.contact.damping = 0.0;
  });
  State start{.angles = straight(model), .rates = straight(model)};
  start.angles << 0.5, 0.3, 0.25, 0.7;
  const ModelInput input = step_input(model, {.current = 0.0, .duration = 0.3, .interval = 1e-3});
  const double before = energy_of(model, start);
  double swing = 0.0;
  for (const State& state : simulate(model, input, start, {.relative = 1e-9})) {
    swing = std::max(swing, model.chain().kinetic_energy(state.angles, state.rates));
    // The magnets' force and energy are two curves, each good to 1e-6 of the largest.
    EXPECT_NEAR(energy_of(model, state), before, 1e-5 * 0.05);
  }
  EXPECT_GT(swing, 5e-3);
}

TEST(Simulate, SaysWhereAMotionLeavesTheModel) {
  const Model model = finger(Configuration::B).model;
  ModelInput input = step_input(model, {.current = 0.0, .duration = 1.0, .interval = 1.0});
  input.joint_torques.assign(2, JointVector::Constant(2, 1.0));
  try {
    (void)simulate(model, input, {.angles = straight(model), .rates = straight(model)});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::MatchesRegex("the motion leaves the model at 0\\.0[0-9]+ s: a joint turns "
                                                    "beyond 180 degrees"));
  }
}

TEST(ModelInput, SaysWhatDoesNotFit) {
  const Model model = finger(Configuration::B).model;
  const ModelInput good = step_input(model, {.current = 0.4, .duration = 0.3, .interval = 0.1});
  const auto text = [&](auto&& change) {
    ModelInput input = good;
    change(input);
    return coilwright::error_text(
        [&] { (void)simulate(model, input, {.angles = straight(model), .rates = straight(model)}); });
  };
  EXPECT_EQ(text([](ModelInput& s) { s.times.clear(); }), "input: at least one sample is needed; got 0");
  EXPECT_EQ(text([](ModelInput& s) { s.currents.pop_back(); }), "input: one row of currents per time, 4 here; got 3");
  EXPECT_EQ(text([&](ModelInput& s) { s.joint_torques.assign(2, straight(model)); }),
            "input: one row of torques per time, 4 here; got 2");
  EXPECT_EQ(text([](ModelInput& s) { s.times[2] = s.times[1]; }), "input: time must increase; sample 2 is at 0.1 s");
  EXPECT_EQ(text([](ModelInput& s) { s.times[3] = NAN; }), "input: time must increase; sample 3 is at nan s");
  EXPECT_EQ(text([](ModelInput& s) { s.currents[1].resize(3); }), "input: sample 1 must have 2 finite currents; got 3");
  EXPECT_EQ(text([](ModelInput& s) { s.currents[1][0] = INFINITY; }),
            "input: sample 1 must have 2 finite currents; got 2");
  EXPECT_EQ(text([](ModelInput& s) { s.joint_torques.assign(4, JointVector::Zero(3)); }),
            "input: sample 0 must have 2 finite torques; got 3");
}

TEST(ModelInput, SamplesStepsAndSines) {
  const Model model = finger(Configuration::B).model;
  const ModelInput step = step_input(model, {.current = 0.4, .duration = 0.35, .interval = 0.1});
  EXPECT_EQ(step.times.size(), 4U);
  EXPECT_DOUBLE_EQ(step.times.back(), 0.3);
  const ModelInput sine =
      sine_input(model, {.amplitude = 0.7, .offset = 0.6, .frequency = 2.0, .duration = 1.0, .interval = 0.0625});
  ASSERT_EQ(sine.times.size(), 17U);
  EXPECT_NEAR(sine.currents[2][1], 1.3, 1e-12);   // a quarter period
  EXPECT_NEAR(sine.currents[6][0], -0.1, 1e-12);  // three quarters
  EXPECT_EQ(
      coilwright::error_text([&] { (void)step_input(model, {.current = 1.0, .duration = -1.0, .interval = 0.1}); }),
      "duration must be finite and > 0; got -1");
  EXPECT_EQ(
      coilwright::error_text([&] { (void)step_input(model, {.current = 1.0, .duration = 1.0, .interval = 0.0}); }),
      "interval must be finite and > 0; got 0");
  EXPECT_EQ(
      coilwright::error_text([&] { (void)step_input(model, {.current = 1.0, .duration = 1.0, .interval = 1e-9}); }),
      "duration / interval must be at most 1000000 samples; got 1000000000: a longer interval, or a shorter duration");
  const CommandedInput ten_seconds{.times = {0.0, 10.0}, .rows = {{1.0}, {1.0}}};
  EXPECT_EQ(coilwright::error_text([&] { (void)sampled_at_least_every(ten_seconds, 1e-6); }),
            "the input at this interval must be at most 1000000 samples; got 10000000: a longer interval, or a shorter "
            "input");
}

}  // namespace
}  // namespace coilwright::simulation
