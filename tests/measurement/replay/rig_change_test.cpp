#include "measurement/replay/rig_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "coilwright/actuator/model/effect_catalogue.hpp"

namespace coilwright::measurement::replay {
namespace {

using mechanics::JointVector;

constexpr double mass = 0.012;  // kg, hung at the tip
constexpr std::array links = {
    mechanics::Link{.length = 0.03, .com_along = 0.014, .com_offset = 0.004, .mass = 0.02, .inertia = 2e-6},
    mechanics::Link{.length = 0.025, .com_along = 0.011, .com_offset = -0.003, .mass = 0.017, .inertia = 1e-6}};

actuator::ModelSpec finger() {
  return {.chain = mechanics::PlanarChain(links, 9.81, 0.1),
          .hinges = {actuator::Hinge{.stiffness = 0.01}, actuator::Hinge{.stiffness = 0.01}},
          .magnetics = {},
          .coils = 0,
          .tip = {}};
}

JointVector pose() {
  return Eigen::Vector2d(0.4, 0.7);
}

// Of the tip by the joint angles: a point of the chain hanging along -y.
Eigen::Matrix2d tip_jacobian(const JointVector& angles) {
  const double first = angles[0];
  const double second = angles[0] + angles[1];
  const Eigen::Vector2d by_first(links[0].length * std::cos(first), links[0].length * std::sin(first));
  const Eigen::Vector2d by_second(links[1].length * std::cos(second), links[1].length * std::sin(second));
  Eigen::Matrix2d out;
  out.col(0) = by_first + by_second;
  out.col(1) = by_second;
  return out;
}

TEST(RigChange, AHungWeightIsAPointMassAtTheTip) {
  const actuator::ModelSpec bare = finger();
  const actuator::ModelSpec loaded = on_changed_rig(finger(), {.tip_mass = mass});
  const Eigen::Matrix2d jacobian = tip_jacobian(pose());
  const Eigen::Matrix2d inertia = bare.chain.mass_matrix(pose()) + mass * jacobian.transpose() * jacobian;
  EXPECT_LT((loaded.chain.mass_matrix(pose()) - inertia).cwiseAbs().maxCoeff(), 1e-15);
  // Gravity pulls at it along -y of a frame that the tilt turns.
  const Eigen::Vector2d upwards(std::sin(0.1), std::cos(0.1));
  const Eigen::Vector2d torques = bare.chain.gravity_torques(pose()) + mass * 9.81 * jacobian.transpose() * upwards;
  EXPECT_LT((loaded.chain.gravity_torques(pose()) - torques).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(RigChange, AWeightComesOnTopOfAPayloadOfTheModel) {
  const actuator::EffectKind* payload = nullptr;
  const actuator::EffectCatalogue catalogue = actuator::standard_effects();
  for (const actuator::EffectKind* kind : catalogue.kinds())
    if (kind->id() == "added_mass") payload = kind;
  ASSERT_NE(payload, nullptr);
  actuator::ModelSpec spec = finger();
  spec.effects = {{.kind = payload, .values = {0.005}}};
  const actuator::ModelSpec loaded = on_changed_rig(spec, {.tip_mass = mass});
  EXPECT_TRUE(loaded.effects.empty());
  EXPECT_NEAR(loaded.chain.link(1).mass, 0.017 + 0.005 + mass, 1e-15);
}

TEST(RigChange, ATurnedBaseAddsToTheTiltOfTheModel) {
  const actuator::ModelSpec turned = on_changed_rig(finger(), {.base_turn = -0.3});
  EXPECT_NEAR(turned.chain.base_tilt(), -0.2, 1e-15);
  const mechanics::PlanarChain expected(links, 9.81, -0.2);
  EXPECT_LT((turned.chain.gravity_torques(pose()) - expected.gravity_torques(pose())).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(RigChange, AnOpenCoilHasNoCurrentThatMotionInduces) {
  const actuator::EffectCatalogue catalogue = actuator::standard_effects();
  const auto left = [&](data::CoilWiring wiring, std::string_view id) {
    actuator::ModelSpec spec = finger();
    for (const actuator::EffectKind* kind : catalogue.kinds())
      if (kind->id() == id) spec.effects = {{.kind = kind, .values = std::vector(kind->parameters().size(), 1.0)}};
    EXPECT_EQ(spec.effects.size(), 1u) << id;
    return on_changed_rig(spec, {.coil = wiring}).effects.size();
  };
  EXPECT_EQ(left(data::CoilWiring::open, "back_emf"), 0u);
  EXPECT_EQ(left(data::CoilWiring::shorted, "back_emf"), 1u);
  EXPECT_EQ(left(data::CoilWiring::open, "dry_friction"), 1u);
  EXPECT_TRUE(current_flows({}));
  EXPECT_FALSE(current_flows({.coil = data::CoilWiring::open}));
  EXPECT_FALSE(current_flows({.coil = data::CoilWiring::shorted}));
}

}  // namespace
}  // namespace coilwright::measurement::replay
