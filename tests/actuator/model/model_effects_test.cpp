#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "actuator/sample_effects.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

using mechanics::JointVector;

Model paper_model() {
  return assemble_or_throw(paper_finger()).model;
}

JointVector pose(double first, double second) {
  JointVector angles(2);
  angles << first, second;
  return angles;
}

TEST(ModelEffects, KeepsWhatItWasMadeOf) {
  const Model bare = paper_model();
  const Model tilted = sample::with_effects(bare, {{&sample::tilt, {0.2}}});
  EXPECT_EQ(tilted.chain().base_tilt(), 0.2);
  EXPECT_EQ(tilted.nominal_spec().chain.base_tilt(), 0.0);
  EXPECT_FALSE(tilted.has_terms());
  ASSERT_EQ(tilted.nominal_spec().effects.size(), 1U);
  const Model straightened = sample::with_effects(tilted, {});
  EXPECT_EQ(straightened.chain().base_tilt(), 0.0);
  EXPECT_EQ(straightened.torques(pose(0.3, 0.2), pose(1.0, 2.0), bare.all_coils(1.0)),
            bare.torques(pose(0.3, 0.2), pose(1.0, 2.0), bare.all_coils(1.0)));
}

TEST(ModelEffects, SaysWhatCannotBeBuiltIn) {
  const Model bare = paper_model();
  const auto text = [&](std::vector<Effect> effects) {
    return error_text([&] { (void)sample::with_effects(bare, std::move(effects)); });
  };
  EXPECT_EQ(text({{&sample::lag, {0.1}}, {&sample::nothing, {}}, {&sample::lag, {0.2}}}),
            "effect sample_lag: may be in a model once; given twice");
  sample::Kind picky = sample::kind_of<sample::Nothing>("picky", Stage::hinge, {});
  picky.refuse = [](const ModelSpec& spec) -> std::optional<std::string> {
    if (spec.chain.joints() == 1) return std::nullopt;
    return "needs a single joint";
  };
  EXPECT_EQ(text({{&picky, {}}}), "effect picky: needs a single joint");
  EXPECT_NO_THROW((void)sample::rig({}, {{&picky, {}}}));
  EXPECT_THAT(text({{}}), testing::HasSubstr("effect"));
}

// Whatever their order in the spec, effects act by stage.
TEST(ModelEffects, ActStageByStage) {
  const Model model = sample::with_effects(paper_model(), {{&sample::camera, {2.0, 0.1, 0.03}},
                                                           {&sample::creep, {1e-3, 1.0, 0.0}},
                                                           {&sample::force_gain, {0.5}},
                                                           {&sample::lag, {0.1}}});
  ASSERT_EQ(model.internal_states(), 4);
  EXPECT_EQ(model.drive_states(), 2);
  const InternalStates states = model.settled(pose(0.3, 0.2), model.all_coils(1.2));
  EXPECT_EQ(states[0], 1.2);
  EXPECT_EQ(states[1], 1.2);
  EXPECT_EQ(states[2], 0.3);
  EXPECT_EQ(states[3], 0.2);
  EXPECT_DOUBLE_EQ(model.observed(0.4), 0.9);
  EXPECT_DOUBLE_EQ(model.delay(), 0.03);
}

TEST(ModelEffects, StandStillOnceSettled) {
  const Model model = sample::with_effects(
      paper_model(), {{&sample::lag, {0.1}}, {&sample::creep, {1e-3, 1.0, 0.0}}, {&sample::friction, {1e-4, 1e-3}}});
  const JointVector angles = pose(0.4, 0.5);
  const CoilCurrents command = model.all_coils(0.9);
  const InternalStates states = model.settled(angles, command);
  InternalStates slopes = InternalStates::Constant(states.size(), NAN);
  JointVector accelerations;
  model.derivative(angles, JointVector::Zero(2), {states.data(), 6}, command, JointVector::Zero(2), accelerations,
                   {slopes.data(), 6});
  EXPECT_EQ(slopes, InternalStates::Zero(6));
  // And the chain is then driven by what static_residual says.
  const JointVector residual = model.static_residual(angles, command);
  EXPECT_LT((model.chain().mass_matrix(angles) * accelerations - residual).norm(), 1e-12 * residual.norm() + 1e-16);
}

// Stiffness against differences of the residual, wide ones: of a spring that an effect adds, with creep relaxed.
TEST(ModelEffects, StiffenThePose) {
  const Model bare = paper_model();
  const Model model = sample::with_effects(
      bare, {{&sample::spring_damper, {7e-3, 3e-5}}, {&sample::creep, {1e-3, 1.0, 0.0}}, {&sample::force_gain, {0.5}}});
  const JointVector angles = pose(0.4, 0.5);
  const mechanics::JointMatrix stiffness = model.tangent_stiffness(angles, model.all_coils(1.0));
  mechanics::JointMatrix expected = bare.tangent_stiffness(angles, bare.all_coils(0.5));
  expected.diagonal().array() += 7e-3;
  EXPECT_LT((stiffness - expected).norm(), 1e-9 * expected.norm());
  EXPECT_EQ(model.damping(angles, model.all_coils(1.0))(0, 0), bare.damping(angles)[0] + 3e-5);
  EXPECT_EQ(model.damping(angles, model.all_coils(1.0))(0, 1), 0.0);
}

TEST(ModelEffects, HoldsWhatIsSlow) {
  const double branch = 2e-3;
  const Model model =
      sample::with_effects(paper_model(), {{&sample::lag, {0.1}}, {&sample::creep, {branch, 30.0, 1.0}}});
  const InternalStates rest = model.settled(pose(0.2, 0.1), model.all_coils(0.0));
  const Model cold = model.with_slow_states_held(rest);
  EXPECT_TRUE(model.has_slow_states());
  EXPECT_FALSE(cold.has_slow_states());
  EXPECT_EQ(cold.internal_states(), 2);
  const JointVector angles = pose(0.5, 0.6);
  const JointVector relaxed = model.static_residual(angles, model.all_coils(1.0));
  const JointVector held = cold.static_residual(angles, cold.all_coils(1.0));
  EXPECT_NEAR(held[0] - relaxed[0], -branch * 0.3, 1e-15);
  EXPECT_NEAR(held[1] - relaxed[1], -branch * 0.5, 1e-15);
  EXPECT_EQ(cold.nominal_spec().effects.size(), 2U);
}

// What cannot be in a design is no fault of its shape, and one line.
TEST(ModelEffects, SayWhyADesignCannotHaveThem) {
  Design design = paper_finger();
  design.layout = layout_of(Configuration::A);
  design.effects = {{standard_effects().find("coil_coil_force"), {}}};
  const std::variant<Assembly, ConstructionFaults> result = assemble(design);
  const auto* faults = std::get_if<ConstructionFaults>(&result);
  ASSERT_NE(faults, nullptr);
  EXPECT_EQ(faults->front().rule, "effect coil_coil_force: the model has one coil only");
  design.layout = layout_of(Configuration::B);
  const Model model = assemble_or_throw(design).model;
  EXPECT_EQ(model.magnetics().distant_pairs().size(), 1U);
  EXPECT_TRUE(model.nominal_spec().magnetics.distant_pairs().empty());
}

}  // namespace
}  // namespace coilwright::actuator
