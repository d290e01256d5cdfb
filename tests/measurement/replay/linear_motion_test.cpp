#include "measurement/replay/linear_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/transient.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Model;
using simulation::State;

// Two links that swing, their joints with friction, drag and a damping.
Model two_links(bool friction) {
  const std::array links{
      mechanics::Link{.length = 0.2, .com_along = 0.2, .com_offset = 0.0, .mass = 0.5, .inertia = 0.01},
      mechanics::Link{.length = 0.3, .com_along = 0.25, .com_offset = 0.0, .mass = 0.6, .inertia = 0.01}};
  actuator::ModelSpec spec{.chain = mechanics::PlanarChain(links),
                           .hinges = {actuator::Hinge{.damping = 0.01}, actuator::Hinge{.damping = 0.02}},
                           .magnetics = {},
                           .coils = 0,
                           .tip = {}};
  spec.effects = {{.kind = actuator::standard_effects().find("quadratic_drag"), .values = {0.01}}};
  if (friction) spec.effects.push_back({.kind = actuator::standard_effects().find("dry_friction"), .values = {0.1}});
  return Model(spec);
}

std::vector<DrivingInput> one_each(const Model& model) {
  std::vector<DrivingInput> out;
  for (int j = 0; j < model.joints(); ++j)
    out.push_back({.currents = actuator::CoilCurrents(0), .torques = mechanics::JointVector::Unit(model.joints(), j)});
  return out;
}

State after(const Model& model, const State& from, const mechanics::JointVector& torques, double duration) {
  const simulation::ModelInput held{.times = {0.0, duration},
                                    .currents = {actuator::CoilCurrents(0), actuator::CoilCurrents(0)},
                                    .joint_torques = {torques, torques}};
  return simulation::simulate(model, held, from, {.relative = 1e-11}).back();
}

Eigen::VectorXd packed(const State& state) {
  Eigen::VectorXd out(state.angles.size() + state.rates.size() + state.internal.size());
  out << state.angles, state.rates, state.internal;
  return out;
}

// Against whole simulations of displaced states and torques, over 2 ms about the middle of the way.
void expect_as_simulated(const Model& model, const State& start, double tolerance) {
  constexpr double duration = 0.002;
  constexpr double change = 1e-5;
  const mechanics::JointVector torques = Eigen::Vector2d(0.3, -0.2);
  const State middle = after(model, start, torques, 0.5 * duration);
  const LinearStep step = step_of(
      linear_motion(model, middle, {.currents = actuator::CoilCurrents(0), .torques = torques}, one_each(model)),
      duration);
  const Eigen::VectorXd end = packed(after(model, start, torques, duration));
  for (Eigen::Index i = 0; i < 2 * model.joints(); ++i) {
    const State moved = displaced(start, change * Eigen::VectorXd::Unit(size_of_changes(model), i));
    const Eigen::VectorXd found = (packed(after(model, moved, torques, duration)) - end) / change;
    EXPECT_LT((found - step.transition.col(i)).lpNorm<Eigen::Infinity>(), tolerance * found.lpNorm<Eigen::Infinity>())
        << i;
  }
  for (int j = 0; j < model.joints(); ++j) {
    const mechanics::JointVector more = torques + change * mechanics::JointVector::Unit(model.joints(), j);
    const Eigen::VectorXd found = (packed(after(model, start, more, duration)) - end) / change;
    EXPECT_LT((found - step.response.col(j)).lpNorm<Eigen::Infinity>(), tolerance * found.lpNorm<Eigen::Infinity>())
        << j;
  }
}

TEST(LinearMotion, OfTwoSwingingLinksIsThatOfDisplacedSimulations) {
  const State start{.angles = Eigen::Vector2d(0.7, -0.4), .rates = Eigen::Vector2d(3.0, -5.0)};
  expect_as_simulated(two_links(false), start, 1e-4);
}

// The states of friction follow from the motion: they have no changes of their own.
TEST(LinearMotion, OfSlidingJointsIsThatOfDisplacedSimulations) {
  const State start{.angles = Eigen::Vector2d(0.7, -0.4),
                    .rates = Eigen::Vector2d(3.0, -5.0),
                    .internal = Eigen::Vector2d(1.0, -1.0)};
  expect_as_simulated(two_links(true), start, 2e-3);
}

TEST(LinearMotion, LeavesHeldJointsAtRest) {
  const Model model = two_links(true);
  const State held{
      .angles = Eigen::Vector2d(0.7, -0.4), .rates = Eigen::Vector2d(3.0, 0.0), .internal = Eigen::Vector2d(1.0, 0.3)};
  const DrivingInput input{.currents = actuator::CoilCurrents(0), .torques = Eigen::Vector2d(0.3, -0.2)};
  LinearMotion motion = linear_motion(model, held, input, one_each(model));
  const LinearMotion free = motion;
  hold_joints(model, held, motion);
  for (const Eigen::Index row : {1, 3}) {
    EXPECT_EQ(motion.by_state.row(row).norm(), 0.0);
    EXPECT_EQ(motion.by_input.row(row).norm(), 0.0);
  }
  for (const Eigen::Index row : {0, 2}) {
    EXPECT_EQ(motion.by_state.row(row), free.by_state.row(row));
    EXPECT_EQ(motion.by_input.row(row), free.by_input.row(row));
  }
}

}  // namespace
}  // namespace coilwright::measurement::replay
