#include "attribution/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
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
        for (const std::string& id : one.request.hidden) EXPECT_FALSE(truth::hidden_kind(id).outsider());
      }
      EXPECT_EQ(one.category == Category::nothing, one.request.hidden.empty());
    }
    EXPECT_EQ(categories[Category::one] + categories[Category::outsider], 80);
    EXPECT_GE(categories[Category::outsider], 14);
    EXPECT_LE(categories[Category::outsider], 16);
    EXPECT_EQ(categories[Category::nothing], 20);
    EXPECT_EQ(categories[Category::two], 20);
    EXPECT_EQ(seeds.size(), 120u);
    EXPECT_EQ(alone.size(), 33u);
    for (const auto& [id, count] : alone) EXPECT_GE(count, 2) << id;
  }
}

// The sets that results/reference/attribution tells of: their effects, and seeds that make the same files.
TEST(Plan, KeepsTheSequenceThatResultsTellOf) {
  const auto cases = plan(0, 120, 1);
  const auto hidden = [&](int number) { return fmt::format("{}", fmt::join(cases[number].request.hidden, "+")); };
  EXPECT_EQ(hidden(0), "angle_scale");
  EXPECT_EQ(hidden(1), "");
  EXPECT_EQ(hidden(3), "off_axis_force+magnet_heating");
  EXPECT_EQ(hidden(5), "mullins_softening");
  EXPECT_EQ(hidden(99), "driver_saturation+force_gain");
  EXPECT_EQ(hidden(101), "loose_contact");
  EXPECT_EQ(hidden(111), "angle_offset+magnet_heating");
  EXPECT_EQ(hidden(118), "off_axis_force");
  EXPECT_EQ(hidden(119), "mullins_softening");
  // sets.csv says 10.98 of set 2.
  truth::DataSetRequest second = cases[2].request;
  second.find_confounders = false;
  EXPECT_NEAR(truth::make_data_set(second).answer.hidden.at(0).strength, 10.98, 0.005);
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
