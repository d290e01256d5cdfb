#include "coilwright/measurement/data/copied_runs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace coilwright::measurement::data {
namespace {

// 20 samples with these readings at the end.
Run run(std::string name, std::vector<double> values) {
  values.insert(values.begin(), 20 - values.size(), values.empty() ? 0.1 : values.front());
  Run out{.name = std::move(name), .kind = RunKind::transient};
  for (std::size_t i = 0; i < values.size(); ++i) out.times.push_back(0.01 * static_cast<double>(i));
  out.channels = {{.name = "bending_angle_deg", .kind = ChannelKind::bending_angle, .values = std::move(values)}};
  return out;
}

TEST(CopiedRuns, AreThoseWithEveryReadingOfAnother) {
  const std::vector<data::Run> fit{run("a.csv", {0.1, 0.2, 0.3}), run("b.csv", {0.1, 0.2, 0.4})};
  const std::vector<data::Run> validate{run("c.csv", {0.1, 0.2}), run("x.csv", {0.1, 0.2, 0.4})};
  const std::vector<Warning> warnings = copied_runs(fit, validate);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].run, "x.csv");
  EXPECT_EQ(
      warnings[0].text,
      "has the readings of b.csv, every one: a copy tells nothing new, and held out of the fit it is no test of it");
}

// A sensor that has stopped is told by a warning of its own, and a few readings may agree by chance.
TEST(CopiedRuns, AreNotThoseThatNeverChangeOrAreShort) {
  EXPECT_TRUE(copied_runs(std::vector{run("a.csv", {0.1, 0.1}), run("b.csv", {0.1, 0.1})}, {}).empty());
  data::Run shorter = run("a.csv", {0.1, 0.2, 0.3});
  shorter.times.pop_back();
  shorter.channels.front().values.pop_back();
  data::Run copy = shorter;
  EXPECT_TRUE(copied_runs(std::vector{std::move(shorter), std::move(copy)}, {}).empty());
}

}  // namespace
}  // namespace coilwright::measurement::data
