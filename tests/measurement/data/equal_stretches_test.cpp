#include "measurement/data/equal_stretches.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace coilwright::measurement::data {
namespace {

TEST(EqualStretches, CoverEverySampleOnceAndDifferFromTheirNeighbours) {
  const std::vector<double> values = {1.0, 1.0, 2.0, 1.0, 0.0, -0.0, 0.0};
  const std::vector<EqualStretch> stretches = equal_stretches(values);
  ASSERT_EQ(stretches.size(), 4U);  // zeros of both signs are one value
  std::size_t next = 0;
  for (const EqualStretch& each : stretches) {
    EXPECT_EQ(each.first, next);
    next = each.end();
  }
  EXPECT_EQ(next, values.size());
  EXPECT_EQ(stretches[0].size, 2U);
  EXPECT_EQ(stretches[1].size, 1U);
  EXPECT_EQ(stretches[2].size, 1U);
  EXPECT_EQ(stretches[3].size, 3U);
}

TEST(EqualStretches, OfNothingAreNone) {
  EXPECT_TRUE(equal_stretches({}).empty());
}

}  // namespace
}  // namespace coilwright::measurement::data
