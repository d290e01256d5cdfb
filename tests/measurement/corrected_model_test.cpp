#include "coilwright/measurement/corrected_model.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/measurement/replay/declare.hpp"

namespace coilwright::measurement {
namespace {

const actuator::EffectKind* kind(std::string_view id) {
  return actuator::standard_effects().find(id);
}

// A pendulum with friction, and a diagnosis of it by hand: other friction, an added mass, and another spring.
TEST(CorrectedModel, HasTheFittedCalibrationAndTheEffectsThatWereAdded) {
  const mechanics::Link link{.length = 0.02, .com_along = 0.01, .mass = 0.015};
  const actuator::ModelSpec spec{.chain = mechanics::PlanarChain(std::span(&link, 1)),
                                 .hinges = {{.stiffness = 0.012, .damping = 1.1e-4}},
                                 .magnetics = {},
                                 .coils = 0,
                                 .tip = {},
                                 .effects = {{.kind = kind("dry_friction"), .values = {1e-4}}}};
  const replay::DeclaredModel declared = replay::declare(spec);
  Diagnosis diagnosis;
  diagnosis.calibration = {{.key = "joint_stiffness_Nmm_rad", .value = 0.013},
                           {.key = "joint_damping_Nmms_rad", .value = 1.2e-4}};
  diagnosis.effects = {{.kind = kind("added_mass"), .parameters = {{.key = "mass_g", .value = 4e-3}}},
                       {.kind = kind("dry_friction"), .parameters = {{.key = "torque_Nmm", .value = 3e-4}}}};

  EXPECT_EQ(calibration_of(diagnosis), (std::vector{0.013, 1.2e-4}));
  const std::vector<actuator::Effect> added = effects_of(diagnosis);
  ASSERT_EQ(added.size(), 2u);
  EXPECT_EQ(added[0].kind, kind("added_mass"));
  EXPECT_EQ(added[0].values, std::vector{4e-3});

  const actuator::ModelSpec corrected = corrected_model(declared, diagnosis);
  EXPECT_EQ(corrected.hinges[0].stiffness, 0.013);
  EXPECT_EQ(corrected.hinges[0].damping, 1.2e-4);
  ASSERT_EQ(corrected.effects.size(), 2u);
  EXPECT_EQ(corrected.effects[0].kind, kind("dry_friction"));
  EXPECT_EQ(corrected.effects[0].values, std::vector{3e-4});
  EXPECT_EQ(corrected.effects[1].kind, kind("added_mass"));
}

}  // namespace
}  // namespace coilwright::measurement
