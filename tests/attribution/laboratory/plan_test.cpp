#include "attribution/laboratory/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "attribution/laboratory/conditions.hpp"
#include "truth/hidden_effects.hpp"

namespace attribution::laboratory {
namespace {

using truth::hidden_kind;
using truth::Standing;

TEST(LaboratoryPlan, HasEachConditionAndEachEffectOftenEnough) {
  const std::vector<Case> cases = plan(PlanName::development);
  EXPECT_GE(cases.size(), 300u);
  std::map<Category, int> categories;
  std::map<std::string, int> with_nothing;
  std::map<std::string, int> pairs;
  std::map<std::string, int> alone;
  std::set<std::uint64_t> seeds;
  for (const Case& one : cases) {
    EXPECT_EQ(one.number, static_cast<int>(&one - cases.data()));
    ++categories[one.category];
    seeds.insert(one.request.seed);
    if (one.category == Category::nothing) {
      EXPECT_TRUE(one.request.hidden.empty());
      ++(one.conditions.size() == 2 ? pairs : with_nothing)[joined(one.conditions)];
    }
    if (one.category == Category::one || one.category == Category::outsider) {
      ASSERT_EQ(one.request.hidden.size(), 1u);
      ++alone[one.request.hidden[0]];
    }
    if (one.category == Category::two || one.category == Category::three) {
      std::set<std::string> ids;
      for (const std::string& name : one.request.hidden) {
        EXPECT_EQ(hidden_kind(name).standing, Standing::catalogue);
        ids.insert(hidden_kind(name).id);
      }
      EXPECT_EQ(ids.size(), one.category == Category::two ? 2u : 3u);
    }
    for (const std::string& name : one.request.hidden) EXPECT_NE(hidden_kind(name).standing, Standing::kept) << name;
  }
  EXPECT_EQ(seeds.size(), cases.size());
  EXPECT_GE(categories[Category::nothing], 150);
  for (const Category category :
       {Category::far, Category::colour_unknown, Category::one, Category::two, Category::three, Category::outsider})
    EXPECT_GE(categories[category], 10) << name_of(category);
  for (const auto& list : {faults(), single_faults(), cameras_and_programmes()})
    for (const Condition& each : list)
      EXPECT_TRUE(each.name == "far_numbers" || with_nothing[each.name] >= 3) << each.name;
  EXPECT_EQ(pairs.size(), 21u);
  for (const truth::HiddenKind& kind : truth::hidden_kinds()) {
    if (kind.standing == Standing::kept || kind.id == "mains_hum") continue;
    EXPECT_GE(alone[kind.name()], kind.outsider() ? 2 : 3) << kind.name();
  }
}

// Whoever runs a tenth of it sees a bit of everything.
TEST(LaboratoryPlan, IsMixed) {
  const std::vector<Case> cases = plan(PlanName::development);
  for (std::size_t first = 0; first + 60 <= cases.size(); first += 60) {
    const auto count = [&](Category category) {
      return std::count_if(cases.begin() + first, cases.begin() + first + 60,
                           [&](const Case& one) { return one.category == category; });
    };
    EXPECT_GE(count(Category::nothing), 12);
    EXPECT_GE(count(Category::one), 6);
    EXPECT_GE(count(Category::outsider), 1);
  }
}

TEST(LaboratoryPlan, KeepsOtherSeedsAndOutsidersForTheEnd) {
  std::set<std::uint64_t> known;
  for (const Case& one : plan(PlanName::development)) known.insert(one.request.seed);
  int kept = 0;
  const std::vector<Case> cases = plan(PlanName::kept);
  EXPECT_GE(cases.size(), 36u);
  for (const Case& one : cases) {
    EXPECT_FALSE(known.contains(one.request.seed));
    if (one.category != Category::outsider) continue;
    EXPECT_EQ(hidden_kind(one.request.hidden[0]).standing, Standing::kept);
    ++kept;
  }
  EXPECT_GE(kept, 8);
}

TEST(LaboratoryPlan, HasEachEffectAloneThrice) {
  const std::vector<Case> cases = plan(PlanName::each_effect);
  std::map<std::string, std::set<std::string>> conditions;
  for (const Case& one : cases) {
    ASSERT_EQ(one.request.hidden.size(), 1u);
    EXPECT_FALSE(one.request.at_bound);
    conditions[one.request.hidden[0]].insert(joined(one.conditions));
  }
  for (const truth::HiddenKind& kind : truth::hidden_kinds()) {
    if (kind.outsider()) continue;
    EXPECT_EQ(conditions[kind.name()], (std::set<std::string>{"30_fps", "clean", "numbers"})) << kind.name();
  }
  EXPECT_EQ(cases.size(), 3 * conditions.size());
}

TEST(LaboratoryPlan, DrawsOtherSetsByAnotherSeed) {
  std::set<std::uint64_t> known;
  for (const Case& one : plan(PlanName::development)) known.insert(one.request.seed);
  const std::vector<Case> other = plan(PlanName::development, {}, 2);
  EXPECT_EQ(other.size(), known.size());
  for (const Case& one : other) EXPECT_FALSE(known.contains(one.request.seed));
}

TEST(LaboratoryPlan, IsTheSameEachTimeAndTakesValues) {
  const std::vector<Case> first = plan(PlanName::development);
  const auto one = std::find_if(first.begin(), first.end(), [](const Case& each) {
    return each.category == Category::one && !hidden_kind(each.request.hidden[0]).numbers.empty();
  });
  const int two = static_cast<int>(
      std::find_if(first.begin(), first.end(), [](const Case& each) { return each.category == Category::two; }) -
      first.begin());
  const std::vector<Case> second = plan(PlanName::development, {{one->number, 0.25}, {two, 0.5}});
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].request.seed, second[i].request.seed);
    EXPECT_EQ(first[i].request.hidden, second[i].request.hidden);
    EXPECT_EQ(first[i].request.camera.exposure_share, second[i].request.camera.exposure_share);
    EXPECT_EQ(second[i].request.values,
              second[i].number == one->number ? std::vector<double>{0.25} : std::vector<double>{});
  }
  EXPECT_THROW((void)condition("earthquake"), std::out_of_range);
}

}  // namespace
}  // namespace attribution::laboratory
