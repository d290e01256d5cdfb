#include "coilwright/actuator/model/effect_catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "actuator/sample_effects.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

using ::testing::ElementsAre;

sample::Kind kind_of_stage(std::string id, Stage stage) {
  return sample::kind_of<sample::DriveGain>(std::move(id), stage, {});
}

std::vector<const EffectKind*> listed(const EffectCatalogue& catalogue) {
  return {catalogue.kinds().begin(), catalogue.kinds().end()};
}

TEST(EffectCatalogue, IsEmptyUnlessToldOtherwise) {
  EXPECT_TRUE(EffectCatalogue().kinds().empty());
  EXPECT_EQ(EffectCatalogue().find("dry_friction"), nullptr);
}

TEST(EffectCatalogue, TakesAKindAfterTheOthersOfItsStage) {
  const EffectCatalogue own = standard_effects().with(sample::force_gain).with(sample::lag);
  ASSERT_EQ(own.kinds().size(), standard_effects().kinds().size() + 2);
  EXPECT_EQ(own.find("sample_lag"), &sample::lag);
  EXPECT_EQ(own.find("dry_friction"), standard_effects().find("dry_friction"));
  std::vector<const EffectKind*> without;
  for (std::size_t i = 0; i < own.kinds().size(); ++i) {
    const EffectKind* kind = own.kinds()[i];
    if (kind != &sample::lag && kind != &sample::force_gain) {
      without.push_back(kind);
      continue;
    }
    EXPECT_EQ(own.kinds()[i - 1]->stage(), kind->stage());
    EXPECT_GT(own.kinds()[i + 1]->stage(), kind->stage());
  }
  EXPECT_EQ(without, listed(standard_effects()));
}

TEST(EffectCatalogue, LeavesTheOneThatItWasMadeFromAsItWas) {
  const std::vector<const EffectKind*> before = listed(standard_effects());
  EXPECT_EQ(standard_effects().with(sample::lag).kinds().size(), before.size() + 1);
  EXPECT_EQ(listed(standard_effects()), before);
  EXPECT_EQ(standard_effects().find("sample_lag"), nullptr);
}

TEST(EffectCatalogue, KeepsTheOrderGivenWithinAStage) {
  const sample::Kind seen = kind_of_stage("seen", Stage::camera);
  const sample::Kind second = kind_of_stage("second", Stage::drive);
  const sample::Kind first = kind_of_stage("first", Stage::drive);
  EXPECT_THAT(listed(EffectCatalogue({&seen, &second, &first})), ElementsAre(&second, &first, &seen));
}

TEST(EffectCatalogue, RefusesWhatHasNoIdOfItsOwn) {
  const sample::Kind nameless = kind_of_stage("", Stage::hinge);
  const sample::Kind known = kind_of_stage("dry_friction", Stage::hinge);
  EXPECT_EQ(error_text([&] { (void)standard_effects().with(known); }),
            "effect catalogue: an id may be there once; dry_friction is there twice");
  EXPECT_EQ(error_text([&] { (void)EffectCatalogue({&nameless}); }), "effect catalogue: an id must not be empty");
  EXPECT_EQ(error_text([&] { (void)EffectCatalogue({&known, nullptr}); }), "effect catalogue: a kind must not be null");
}

}  // namespace
}  // namespace coilwright::actuator
