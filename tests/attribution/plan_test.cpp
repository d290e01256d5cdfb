#include "attribution/plan.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "truth/hidden.hpp"

namespace attribution {
namespace {

TEST(Plan, HidesEverythingOftenEnough) {
  for (const std::uint64_t seed : {1u, 2u, 99u}) {
    std::map<Category, int> categories;
    std::map<std::string, int> alone;
    std::set<std::uint64_t> seeds;
    for (const Case& one : plan(0, 120, seed)) {
      ++categories[one.category];
      seeds.insert(one.order.seed);
      if (one.category == Category::one || one.category == Category::outsider) {
        ASSERT_EQ(one.order.hidden.size(), 1u);
        ++alone[one.order.hidden[0]];
      }
      if (one.category == Category::two) {
        ASSERT_EQ(one.order.hidden.size(), 2u);
        EXPECT_NE(one.order.hidden[0], one.order.hidden[1]);
        for (const std::string& id : one.order.hidden) EXPECT_FALSE(truth::hidden_kind(id).outsider);
      }
      EXPECT_EQ(one.category == Category::nothing, one.order.hidden.empty());
    }
    EXPECT_EQ(categories[Category::one], 60);
    EXPECT_EQ(categories[Category::nothing], 20);
    EXPECT_EQ(categories[Category::two], 20);
    EXPECT_EQ(categories[Category::outsider], 20);
    EXPECT_EQ(seeds.size(), 120u);
    for (const truth::HiddenKind& kind : truth::hidden_kinds()) EXPECT_GE(alone[kind.id], 2) << kind.id;
  }
}

TEST(Plan, IsOneRowHoweverItIsCut) {
  const auto whole = plan(0, 30, 4);
  const auto part = plan(12, 6, 4);
  for (std::size_t i = 0; i < part.size(); ++i) {
    EXPECT_EQ(part[i].number, whole[i + 12].number);
    EXPECT_EQ(part[i].order.hidden, whole[i + 12].order.hidden);
    EXPECT_EQ(part[i].order.seed, whole[i + 12].order.seed);
  }
  EXPECT_NE(plan(0, 1, 5)[0].order.seed, whole[0].order.seed);
}

}  // namespace
}  // namespace attribution
