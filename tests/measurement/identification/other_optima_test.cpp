#include "measurement/identification/other_optima.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::standard_effects;

FittedHypothesis fitted_with(const replay::DeclaredModel& declared, std::vector<actuator::Effect> effects) {
  FittedHypothesis out{.hypothesis = fit::Hypothesis(declared, std::move(effects))};
  out.fit.values = out.hypothesis.start();
  return out;
}

TEST(OtherStarts, AreWhereAnotherValleyMayBe) {
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  declared.calibration.front().other_start = 3.0 * true_mass;
  const FittedHypothesis plain = fitted_with(declared, {});
  const std::vector<PlannedFit> of_plain = with_other_starts(plain, 1);
  ASSERT_EQ(of_plain.size(), 2u);
  EXPECT_EQ(of_plain[0].start[0], 3.0 * true_mass);

  // A fit that ended near the other start is tried from the declared number.
  FittedHypothesis moved = plain;
  moved.fit.values[0] = 2.9 * true_mass;
  moved.fit.values[1] = 0.1 * true_damping;
  const std::vector<PlannedFit> of_moved = with_other_starts(moved, 1);
  EXPECT_EQ(of_moved[0].start[0], true_mass);
  EXPECT_EQ(of_moved[0].start[1], 0.1 * true_damping);
  // And wherever it ended, from the other start with nothing bent yet by what is to be left.
  EXPECT_EQ(of_moved[1].start[0], 3.0 * true_mass);
  EXPECT_EQ(of_moved[1].start[1], true_damping);
  EXPECT_EQ(of_moved[1].local_numbers_from, nullptr);

  FittedHypothesis friction =
      fitted_with(declared, {{.kind = standard_effects().find("dry_friction"), .values = {1.0}}});
  friction.fit.values[0] = 1.1 * true_mass;
  const std::vector<PlannedFit> of_friction = with_other_starts(friction, 1);
  ASSERT_EQ(of_friction.size(), 4u);
  EXPECT_EQ(of_friction[0].start[0], true_mass);  // from the declared number
  EXPECT_EQ(of_friction[0].start[2], 1.0);
  EXPECT_NEAR(of_friction[1].start[2], 0.3, 1e-12);
}

TEST(OtherStarts, AreScatteredForEffectsOfSeveralNumbersByTheSeedAlone) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const FittedHypothesis creep =
      fitted_with(declared, {{.kind = standard_effects().find("viscoelastic_creep"), .values = {0.2, 0.5}}});
  const auto last = [&](std::uint64_t seed) { return with_other_starts(creep, seed).back().start; };
  EXPECT_EQ(last(1), last(1));
  EXPECT_NE(last(1), last(2));
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Eigen::VectorXd start = last(seed);
    EXPECT_GE(start[2], 0.2 / 3.0);
    EXPECT_LE(start[2], 0.2 * 3.0);
    EXPECT_GE(start[3], 0.5 / 3.0);
    EXPECT_LE(start[3], 0.5 * 3.0);
  }
}

TEST(FurtherNumbers, StartBesideTheEffectAsItWasFoundAndAsItStartsByItself) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  FittedHypothesis friction =
      fitted_with(declared, {{.kind = standard_effects().find("dry_friction"), .values = {0.7}}});
  const actuator::RigScale scale{.torque = 1.0, .angle = 1.0, .rate = 10.0, .interval = 0.01, .duration = 1.0};
  const auto as_found = [](const PlannedFit& plan) {
    const actuator::Effect larger = plan.hypothesis.effects_at(plan.start)[0];
    EXPECT_EQ(larger.kind->id(), "dry_friction");
    EXPECT_EQ(larger.values.size(), 3u);
    EXPECT_NEAR(larger.values[1], 1.4, 1e-12);
    return larger.values[0] == 0.7;
  };
  friction.whiteness.level = 1.0;
  const std::vector<PlannedFit> near = with_further_numbers(friction, scale);
  EXPECT_EQ(near.size(), 9u);  // three rates, each with three torques
  EXPECT_EQ(std::ranges::count_if(near, as_found), 3);
  friction.whiteness.level = 50.0;
  const std::vector<PlannedFit> far = with_further_numbers(friction, scale);
  EXPECT_EQ(far.size(), 3u);
  EXPECT_EQ(std::ranges::count_if(far, as_found), 3);
  EXPECT_TRUE(with_further_numbers(fitted_with(declared, {}), {}).empty());
}

}  // namespace
}  // namespace coilwright::measurement::identification
