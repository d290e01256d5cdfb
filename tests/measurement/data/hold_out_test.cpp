#include "coilwright/measurement/data/hold_out.hpp"

#include <gmock/gmock.h>

namespace coilwright::measurement::data {
namespace {

using testing::ElementsAre;

Dataset set_of(int transients, int benches) {
  Dataset data;
  for (int i = 0; i < transients; ++i)
    data.fit.push_back({.name = "motion" + std::to_string(i), .kind = RunKind::transient});
  for (int i = 0; i < benches; ++i)
    data.fit.push_back({.name = "bench" + std::to_string(i), .kind = RunKind::static_torque});
  return data;
}

TEST(HoldOut, SealsEveryFourthRunOfEachKind) {
  const Dataset data = with_runs_held_out(set_of(6, 2));
  EXPECT_THAT(data.held_out, ElementsAre("motion1", "motion5", "bench1"));
  EXPECT_EQ(data.validate.count(), 3u);
  ASSERT_EQ(data.fit.size(), 5u);
  EXPECT_EQ(data.fit[1].name, "motion2");
}

TEST(HoldOut, KeepsASingleRunForTheFit) {
  const Dataset data = with_runs_held_out(set_of(1, 1));
  EXPECT_TRUE(data.validate.empty());
  EXPECT_EQ(data.fit.size(), 2u);
}

TEST(HoldOut, DoesNotChangeASetWithValidateRuns) {
  Dataset data = set_of(4, 0);
  data.validate = SealedRuns({data::Run{.name = "other"}});
  data = with_runs_held_out(std::move(data));
  EXPECT_EQ(data.fit.size(), 4u);
  EXPECT_THAT(data.held_out, ElementsAre());
}

}  // namespace
}  // namespace coilwright::measurement::data
