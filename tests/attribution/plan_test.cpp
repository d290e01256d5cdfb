#include "attribution/plan.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "truth/hidden_effects.hpp"

namespace attribution {
namespace {

TEST(Plan, HidesEverythingOftenEnough) {
  for (const std::uint64_t seed : {1u, 2u, 99u}) {
    std::map<Category, int> categories;
    std::map<std::string, int> alone;
    std::set<std::uint64_t> seeds;
    for (const Case& one : plan(0, 120, seed)) {
      ++categories[one.category];
      seeds.insert(one.request.seed);
      if (one.category == Category::one || one.category == Category::outsider) {
        ASSERT_EQ(one.request.hidden.size(), 1u);
        ++alone[one.request.hidden[0]];
      }
      if (one.category == Category::two) {
        ASSERT_EQ(one.request.hidden.size(), 2u);
        EXPECT_NE(one.request.hidden[0], one.request.hidden[1]);
        for (const std::string& id : one.request.hidden) EXPECT_FALSE(truth::hidden_kind(id).outsider);
      }
      EXPECT_EQ(one.category == Category::nothing, one.request.hidden.empty());
    }
    EXPECT_EQ(categories[Category::one], 60);
    EXPECT_EQ(categories[Category::nothing], 20);
    EXPECT_EQ(categories[Category::two], 20);
    EXPECT_EQ(categories[Category::outsider], 20);
    EXPECT_EQ(seeds.size(), 120u);
    for (const truth::HiddenKind& kind : truth::hidden_kinds()) EXPECT_GE(alone[kind.id], 2) << kind.id;
  }
}

TEST(Plan, IsOneSequenceHoweverItIsDivided) {
  const auto whole = plan(0, 30, 4);
  const auto part = plan(12, 6, 4);
  for (std::size_t i = 0; i < part.size(); ++i) {
    EXPECT_EQ(part[i].number, whole[i + 12].number);
    EXPECT_EQ(part[i].request.hidden, whole[i + 12].request.hidden);
    EXPECT_EQ(part[i].request.seed, whole[i + 12].request.seed);
  }
  EXPECT_NE(plan(0, 1, 5)[0].request.seed, whole[0].request.seed);
}

}  // namespace
}  // namespace attribution
