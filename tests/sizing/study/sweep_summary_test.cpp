#include "coilwright/sizing/study/sweep_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

using testing::small_study;

SweepSummary whole(const DesignProblem& problem, Keep keep) {
  SweepSummary summary(problem, keep);
  sweep(problem, {.threads = 1}, [&](const SweptDesign& design) { summary.consider(design); });
  return summary;
}

std::vector<std::size_t> indices(const std::vector<SweptDesign>& designs) {
  std::vector<std::size_t> out;
  for (const SweptDesign& design : designs) out.push_back(design.index);
  return out;
}

TEST(PartOfASweep, HasEveryIndexOnceWithItsFellows) {
  for (const std::size_t count : {0u, 1u, 7u, 36u})
    for (const std::size_t of : {1u, 5u, 36u, 50u}) {
      std::size_t next = 0;
      for (std::size_t number = 1; number <= of; ++number) {
        const IndexRange range = range_of({.number = number, .of = of}, count);
        EXPECT_EQ(range.first, next);
        EXPECT_LE(range.end - range.first, count / of + 1);
        next = range.end;
      }
      EXPECT_EQ(next, count);
    }
  EXPECT_EQ(range_of({.number = most_parts_of_a_run, .of = most_parts_of_a_run}, 1'000'000'000'000).end,
            1'000'000'000'000u);
}

// Against every pair of feasible designs.
TEST(SweepSummary, KeepsTheFrontOfFeasibleDesigns) {
  const DesignProblem problem(small_study());
  std::vector<SweptDesign> feasible;
  sweep(problem, {.threads = 1}, [&](const SweptDesign& design) {
    if (is_feasible(design.evaluation)) feasible.push_back(design);
  });
  std::vector<std::size_t> expected;
  for (const SweptDesign& one : feasible) {
    bool beaten = false;
    for (const SweptDesign& other : feasible) {
      const auto &a = other.evaluation.objectives, &b = one.evaluation.objectives;  // speed up, mass down
      const bool no_worse = a[0] >= b[0] && a[1] <= b[1], better = a[0] > b[0] || a[1] < b[1];
      beaten = beaten || (no_worse && (better || other.index < one.index));
    }
    if (!beaten) expected.push_back(one.index);
  }
  ASSERT_GT(expected.size(), 1u);
  ASSERT_LT(expected.size(), feasible.size());
  EXPECT_EQ(indices(whole(problem, Keep::front).front()), expected);
}

TEST(ExactSum, LosesNothingWhateverTheOrder) {
  const std::vector<double> values{1e300, 3.5, -1e300, 0x1p-1074, -0.75, 1e-310, -2.5};
  ExactSum forwards, backwards, apart;
  for (std::size_t i = 0; i < values.size(); ++i) {
    forwards.add(values[i]);
    backwards.add(values[values.size() - 1 - i]);
  }
  for (const double value : values) {
    ExactSum one;
    one.add(value);
    apart.add(ExactSum(one.text()));
  }
  EXPECT_EQ(forwards.text(), backwards.text());
  EXPECT_EQ(forwards.text(), apart.text());
  EXPECT_EQ(forwards.value(), 0.25);  // and some 1e-310, which a double next to 0.25 cannot show
  ExactSum rest = forwards;
  rest.add(-0.25);
  EXPECT_EQ(rest.value(), 1e-310 + 0x1p-1074);
}

// Integers, whose sum long integers know.
TEST(ExactSum, IsTheSumOfIntegers) {
  std::mt19937_64 random(5);
  ExactSum sum;
  std::int64_t expected = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t value = static_cast<std::int64_t>(random() >> 20) - (std::int64_t{1} << 43);
    sum.add(static_cast<double>(value));
    expected += value;
  }
  EXPECT_EQ(sum.value(), static_cast<double>(expected));
  EXPECT_EQ(ExactSum().value(), 0.0);
  EXPECT_EQ(ExactSum().text(), "0");
}

TEST(ExactSum, RefusesATextThatIsNoInteger) {
  for (const char* text : {"", "-", "1.5", "0x1", "1-"}) EXPECT_THROW(ExactSum{text}, std::invalid_argument) << text;
}

}  // namespace
}  // namespace coilwright::sizing
