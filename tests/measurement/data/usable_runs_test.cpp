#include "measurement/data/usable_runs.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "error_text.hpp"

namespace coilwright::measurement::data {
namespace {

data::Run run_of(const char* name, bool stuck, bool driven) {
  data::Run run{.name = name, .kind = RunKind::transient};
  Channel moving{.name = "theta1_deg", .kind = ChannelKind::joint_angle};
  Channel still{.name = "theta2_deg", .kind = ChannelKind::joint_angle, .joint = 1};
  for (int i = 0; i < 40; ++i) {
    run.times.push_back(0.01 * i);
    run.inputs.push_back({driven ? std::sin(0.3 * i) : 0.0});
    moving.values.push_back(std::cos(0.2 * i));
    still.values.push_back(stuck ? 0.4 : std::cos(0.1 * i));
  }
  run.channels = {moving, still};
  return run;
}

TEST(UsableRuns, LeaveOutStuckChannelsWithAWarning) {
  const auto [kept, warnings] = usable_runs({run_of("a.csv", true, true), run_of("b.csv", false, true)});
  ASSERT_EQ(kept.size(), 2u);
  ASSERT_EQ(kept[0].channels.size(), 1u);
  EXPECT_EQ(kept[0].channels[0].name, "theta1_deg");
  EXPECT_EQ(kept[1].channels.size(), 2u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].run, "a.csv");
  EXPECT_EQ(warnings[0].text, "theta2_deg never changes while the input moves; left out");
}

TEST(UsableRuns, KeepARigThatIsNotDriven) {
  const UsableRuns usable = usable_runs({run_of("a.csv", true, false)});
  EXPECT_EQ(usable.runs[0].channels.size(), 2u);
  EXPECT_TRUE(usable.warnings.empty());
}

TEST(UsableRuns, RefuseASetOfStuckChannels) {
  data::Run run = run_of("a.csv", true, true);
  run.channels.erase(run.channels.begin());
  EXPECT_EQ(error_text([&] { (void)usable_runs({run}); }), "fit runs: every measured column is stuck at one value");
}

}  // namespace
}  // namespace coilwright::measurement::data
