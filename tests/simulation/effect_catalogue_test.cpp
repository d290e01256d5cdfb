#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "actuator/effects/rig.hpp"
#include "actuator/sample_effects.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/transient.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;
using actuator::RigScale;
using mechanics::JointVector;

Model finger_with(std::vector<Effect> effects) {
  actuator::ModelSpec spec = effects.empty() ? actuator::finger() : actuator::finger_for(*effects.front().kind);
  spec.effects = std::move(effects);
  return Model(std::move(spec));
}

JointVector rest_of(const Model& model, double current) {
  const std::optional<JointVector> angles =
      find_equilibrium(model, model.all_coils(current), JointVector::Constant(model.joints(), 0.1));
  return angles.value();
}

// Up, down, reversed and released, 0.3 s each, at 500 Hz.
ModelInput exercise(const Model& model) {
  ModelInput input;
  for (int i = 0; i <= 600; ++i) {
    constexpr double levels[] = {1.4, 0.35, -0.4, 0.0};
    input.times.push_back(2e-3 * i);
    input.currents.push_back(model.all_coils(levels[std::min(i / 150, 3)]));
  }
  return input;
}

// From the rest of the finger without effects, its effects settled there.
std::vector<State> exercised(const Model& model) {
  const JointVector rest = rest_of(finger_with({}), 0.0);
  const ModelInput input = exercise(model);
  State start{.angles = rest, .rates = JointVector::Zero(2)};
  if (model.internal_states() > 0) start.internal = model.settled(rest, model.all_coils(0.0));
  return simulate(model, input, start);
}

double bending(const Model& model, const State& state) {
  const std::span<const double> internal(state.internal.data(), static_cast<std::size_t>(state.internal.size()));
  return model.observed(Model::bending_angle(model.shown(state.angles, state.rates, internal).angles));
}

// Largest difference between what two models show of the same exercise, rad.
double difference(const Model& a, const Model& b) {
  const std::vector<State> one = exercised(a);
  const std::vector<State> other = exercised(b);
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
    largest = std::max(largest, std::abs(bending(a, one[i]) - bending(b, other[i])));
  return largest;
}

RigScale scale_of_exercise() {
  RigScale scale{.torque = 8e-3, .angle = 0.3, .current = 1.4, .interval = 2e-3, .duration = 1.2};
  scale.lower_angle = 1e9;
  scale.upper_angle = -1e9;
  for (const State& state : exercised(finger_with({}))) {
    scale.rate = std::max(scale.rate, state.rates.lpNorm<Eigen::Infinity>());
    scale.lower_angle = std::min(scale.lower_angle, state.angles.minCoeff());
    scale.upper_angle = std::max(scale.upper_angle, state.angles.maxCoeff());
  }
  return scale;
}

// The smallest that a camera of 0.3 degrees shows over these 600 samples, rad: 0.3 / sqrt(600) degrees.
constexpr double visible = 2e-4;

TEST(EffectCatalogue, ShowsInTheMotionFromSomeStart) {
  const Model nominal = finger_with({});
  const RigScale scale = scale_of_exercise();
  for (const EffectKind* kind : actuator::standard_effects().kinds()) {
    double largest = 0.0;
    for (const std::vector<double>& start : kind->starts(scale)) {
      const Model model = finger_with({{.kind = kind, .values = start}});
      largest = std::max(largest, model.delay() > 0.0 ? scale.rate * model.delay() : difference(model, nominal));
    }
    EXPECT_GT(largest, visible) << kind->id();
  }
}

// A millionth of an effect is a millionth of its difference, or lost in the integrator's 1e-7: no effect switches on. A
// stop's damping goes with the square root of its stiffness.
TEST(EffectCatalogue, FadesOutTowardsAbsent) {
  const Model nominal = finger_with({});
  for (const EffectKind* kind : actuator::standard_effects().kinds()) {
    const std::vector<double> start = kind->starts(scale_of_exercise()).front();
    const double whole = difference(finger_with({{.kind = kind, .values = start}}), nominal);
    for (std::size_t i = 0; i < start.size(); ++i) {
      const std::optional<double> absent = kind->parameters()[i].absent;
      if (!absent || std::isinf(*absent)) continue;
      std::vector<double> values = start;
      values[i] = *absent + 1e-6 * (start[i] - *absent);
      const Model model = finger_with({{.kind = kind, .values = values}});
      const double share = kind->id() == "end_stop" ? 1e-3 : 1e-6;
      EXPECT_LT(difference(model, nominal), 5.0 * share * whole + 1e-6) << kind->id();
    }
  }
}

TEST(EffectCatalogue, StaysInItsEquilibrium) {
  for (const EffectKind* kind : actuator::standard_effects().kinds()) {
    for (const std::vector<double>& start : kind->starts(scale_of_exercise())) {
      const Model model = finger_with({{.kind = kind, .values = start}});
      const JointVector rest = rest_of(model, 0.9);
      const ModelInput input = step_input(model, {.current = 0.9, .duration = 1.0, .interval = 0.1});
      const State settled{.angles = rest,
                          .rates = JointVector::Zero(2),
                          .internal = model.settled(rest, model.all_coils(0.9), actuator::InitialHistory::long_hold)};
      const std::vector<State> motion = simulate(model, input, settled);
      for (const State& state : motion)
        EXPECT_LT((state.angles - rest).lpNorm<Eigen::Infinity>(), 1e-6) << kind->id();  // equilibria to 1e-11
    }
  }
}

// A lag in closed form beside the same one integrated with a tenth of the error, with each other effect; a slow one,
// and one that is over within each sample. On a sine in steps: what bounces forgets where it was.
TEST(EffectCatalogue, TakesTheCoilsLagInClosedForm) {
  const RigScale scale = scale_of_exercise();
  const EffectKind* lag = actuator::standard_effects().find("coil_lag");
  for (const EffectKind* kind : actuator::standard_effects().kinds()) {
    if (kind == lag || kind->inapplicable(actuator::finger())) continue;
    for (const double time : {3e-4, 5e-3}) {
      const Effect other{.kind = kind, .values = kind->starts(scale).front()};
      const Model closed = finger_with({other, {.kind = lag, .values = {time}}});
      const Model integrated = finger_with({other, {.kind = &actuator::sample::lag, .values = {time}}});
      EXPECT_EQ(closed.drive_lag(), closed.drive_states() == 2 ? time : 0.0) << kind->id();
      EXPECT_EQ(integrated.drive_lag(), 0.0);
      const ModelInput input =
          sine_input(closed, {.amplitude = 0.7, .offset = 0.7, .frequency = 2.0, .duration = 0.4, .interval = 2e-3});
      const State start{.angles = rest_of(finger_with({}), 0.7), .rates = JointVector::Zero(2)};
      const std::vector<State> one = simulate(closed, input, start);
      const std::vector<State> exact = simulate(integrated, input, start, {.relative = 1e-8});
      // The errors of the steps of some ten samples, each 1e-7 of the motion; a lag of 0.3 ms itself shifts it by 1e-3.
      for (std::size_t i = 0; i < one.size(); i += 3) {
        ASSERT_LT((one[i].angles - exact[i].angles).lpNorm<Eigen::Infinity>(), 1e-6) << kind->id() << time;
        ASSERT_LT((one[i].internal - exact[i].internal).head(2).lpNorm<Eigen::Infinity>(), 1e-6) << kind->id() << time;
      }
    }
  }
}

// Every effect at once: they share the row of states without treading on each other.
TEST(EffectCatalogue, RunsAllAtOnce) {
  std::vector<Effect> all;
  for (const EffectKind* kind : actuator::standard_effects().kinds())
    if (!kind->inapplicable(actuator::finger()))
      all.push_back({.kind = kind, .values = kind->starts(scale_of_exercise()).front()});
  std::reverse(all.begin(), all.end());
  const Model model = finger_with(all);
  // Two coils heat and lag, the magnets heat, two are loose, two joints soften, creep, loop and rub, the mount moves,
  // and the camera filters both joints.
  EXPECT_EQ(model.internal_states(), 4 + 1 + 4 + 8 + 2 + 2);
  for (const State& state : exercised(model)) EXPECT_TRUE(state.angles.allFinite() && state.internal.allFinite());
}

}  // namespace
}  // namespace coilwright::simulation
