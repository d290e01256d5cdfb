// Sets from the independent simulation, diagnosed and scored as in the benchmark, with a quarter of the samples.

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "attribution/run_case.hpp"

namespace attribution {
namespace {

using coilwright::measurement::Verdict;

struct Hidden {
  std::string name;
  Category category{};
  std::vector<std::string> ids{};
  std::uint64_t seed = 1;
};

void PrintTo(const Hidden& hidden, std::ostream* out) {
  *out << hidden.name;
}

class AttributionSet : public testing::TestWithParam<Hidden> {
 protected:
  [[nodiscard]] static Outcome outcome() {
    const Hidden& hidden = GetParam();
    Case asked{.category = hidden.category, .request = {.hidden = hidden.ids, .seed = hidden.seed}};
    asked.request.programme = truth::Programme::brief;
    asked.request.weakest = 5.0;
    return run_case(asked, 2).outcome;
  }
};

using NothingHidden = AttributionSet;
TEST_P(NothingHidden, IsNoMissingEffect) {
  const Outcome found = outcome();
  EXPECT_EQ(found.verdict, Verdict::no_missing_effect);
  EXPECT_TRUE(found.reported.empty());
  ASSERT_TRUE(found.error_over_floor.has_value());
  EXPECT_LE(*found.error_over_floor, 1.1);
  EXPECT_EQ(found.calibration_intervals.of, 2);
}

using OneHidden = AttributionSet;
TEST_P(OneHidden, IsFoundAndExplainsTheResidual) {
  const Outcome found = outcome();
  EXPECT_TRUE(found.found) << (found.reported.empty() ? "nothing" : found.reported.front());
  EXPECT_EQ(found.verdict, Verdict::explained);
  ASSERT_TRUE(found.error_over_floor.has_value());
  EXPECT_LE(*found.error_over_floor, 1.1);
}

using TwoHidden = AttributionSet;
TEST_P(TwoHidden, AreBothFound) {
  const Outcome found = outcome();
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.verdict, Verdict::explained);
}

using Outsider = AttributionSet;
TEST_P(Outsider, IsNotExplained) {
  const Outcome found = outcome();
  EXPECT_NE(found.verdict, Verdict::explained);
  EXPECT_NE(found.verdict, Verdict::no_missing_effect);
}

std::string name_of_case(const testing::TestParamInfo<Hidden>& hidden) {
  return hidden.param.name;
}

Hidden one(const std::string& id, std::uint64_t seed) {
  return {.name = id, .category = Category::one, .ids = {id}, .seed = seed};
}

INSTANTIATE_TEST_SUITE_P(Truth, NothingHidden,
                         testing::Values(Hidden{.name = "first", .category = Category::nothing, .seed = 1},
                                         Hidden{.name = "second", .category = Category::nothing, .seed = 2}),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Truth, OneHidden,
                         testing::Values(one("driver_deadband", 1), one("driver_saturation", 1), one("force_gain", 1),
                                         one("dry_friction", 1), one("stiffness_hardening", 1), one("base_tilt", 1),
                                         one("angle_scale", 1), one("mount_compliance", 2)),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Truth, TwoHidden,
                         testing::Values(Hidden{.name = "friction_and_delay",
                                                .category = Category::two,
                                                .ids = {"dry_friction", "measurement_delay"},
                                                .seed = 1}),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(
    Truth, Outsider,
    testing::Values(Hidden{.name = "shaken_base", .category = Category::outsider, .ids = {"shaken_base"}, .seed = 1},
                    Hidden{.name = "mains_hum", .category = Category::outsider, .ids = {"mains_hum"}, .seed = 1}),
    name_of_case);

}  // namespace
}  // namespace attribution
