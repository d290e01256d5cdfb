#include "coilwright/simulation/initial_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/transient.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;
using actuator::Model;
using mechanics::JointVector;

// A fifth more resistance in the steady state at 1 A.
Model warming_finger(double warm_start) {
  actuator::ModelSpec spec = finger(Configuration::B).model.nominal_spec();
  spec.effects = {{.kind = actuator::standard_effects().find("coil_heating"), .values = {0.2, 3.0, warm_start}}};
  return Model(std::move(spec));
}

State start_of(const Model& model) {
  return equilibrium_at_first_input(model, model_input(model, {.times = {0.0, 6.0}, .rows = {{1.0}, {1.0}}})).value();
}

// Cold, the coils carry the commanded ampere; warm, x (1 + x) = 0.2 of resistance more and so much less current.
TEST(EquilibriumAtFirstInput, IsColdOrWarmAsTheRunWas) {
  const Model nominal = finger(Configuration::B).model;
  const auto pose = [&](double current) {
    return find_equilibrium(nominal, nominal.all_coils(current), straight(nominal)).value();
  };
  const State cold = start_of(warming_finger(0.0));
  EXPECT_EQ(cold.internal, Eigen::VectorXd::Zero(2));
  EXPECT_LT((cold.angles - pose(1.0)).norm(), 1e-9);
  const double rise = 0.5 * (std::sqrt(1.8) - 1.0);
  const State warm = start_of(warming_finger(1.0));
  EXPECT_LT((warm.internal - Eigen::VectorXd::Constant(2, rise)).norm(), 1e-12);
  EXPECT_LT((warm.angles - pose(1.0 / (1.0 + rise))).norm(), 1e-9);
  EXPECT_EQ(cold.rates, JointVector::Zero(2));
}

// What a start leaves open is found as a recorded run finds it, so that both ways into a motion agree.
TEST(EquilibriumAtFirstInput, IsWhereAMotionWithoutInternalStatesStarts) {
  const Model model = warming_finger(0.0);
  const ModelInput input = step_input(model, {.current = 1.0, .duration = 2.0, .interval = 1.0});
  const State start = equilibrium_at_first_input(model, input).value();
  const State open{.angles = start.angles, .rates = start.rates};
  EXPECT_EQ(simulate(model, input, open).back().angles, simulate(model, input, start).back().angles);
}

TEST(EquilibriumAtFirstInput, BalancesATorqueAtTheJoints) {
  const Model model = finger(Configuration::B).model;
  const CommandedInput pushed{.drive = Drive::torque, .times = {0.0}, .rows = {{2e-3, 1e-3}}};
  const State start = equilibrium_at_first_input(model, model_input(model, pushed)).value();
  const JointVector left = model.static_residual(start.angles, model.all_coils(0.0));
  EXPECT_NEAR(left[0], -2e-3, 1e-12);
  EXPECT_NEAR(left[1], -1e-3, 1e-12);
}

// A free mass that is pushed has nowhere to rest: it starts straight, where it was put.
TEST(EquilibriumAtFirstInput, IsStraightForARigThatNothingHolds) {
  const mechanics::Link link{.length = 1.0, .com_along = 1.0, .com_offset = 0.0, .mass = 2.0, .inertia = 0.0};
  const Model model({.chain = mechanics::PlanarChain(std::span(&link, 1), 0.0),
                     .hinges = {actuator::Hinge{}},
                     .magnetics = {},
                     .coils = 0,
                     .tip = {}});
  const CommandedInput pushed{.drive = Drive::torque, .times = {0.0}, .rows = {{3.0}}};
  EXPECT_EQ(equilibrium_at_first_input(model, model_input(model, pushed)).value().angles, JointVector::Zero(1));
}

}  // namespace
}  // namespace coilwright::simulation
